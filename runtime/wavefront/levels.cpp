#include "runtime/wavefront/levels.h"

#include <algorithm>

namespace brandung {
namespace {

/// Smaller launches leave a device half idle.
constexpr uint worthwhile_launch = 16384;

}  // namespace

Levels::Levels(Device &device, uint batch, uint branching, uint generations, uint interior_size, bool instances)
    : device_(device),
      batch_(batch),
      capacity_(std::max(batch, branching)),
      branching_(branching),
      generations_(generations),
      interior_size_(interior_size),
      full_launch_(std::min(batch, worthwhile_launch)),
      instances_(instances),
      level_bytes_(capacity_ * (sizeof(Ray) + sizeof(Path) + sizeof(uint) * (1 + interior_size + (instances ? 1 : 0)))) {}

Level &Levels::level(uint generation) {
    while (levels_.size() <= generation) levels_.emplace_back(device_, capacity_, interior_size_, instances_);
    return levels_[generation];
}

Level &Levels::start(uint count) {
    for (Level &level : levels_) level.used = level.first = level.end = 0;
    Level &first = level(0);
    first.used = first.end = count;
    return first;
}

/// How many items of a level can be worked on, given the free slots below.
uint Levels::room(uint generation) {
    const Level &here = levels_[generation];
    const uint waiting = here.end - here.first;
    if (branching_ == 0 || generation + 1 == generations_) return std::min(waiting, batch_);
    const uint free = generation + 1 < levels_.size() ? capacity_ - levels_[generation + 1].used : capacity_;
    return std::min({waiting, batch_, free / branching_});
}

std::optional<Wave> Levels::next() {
    uint chosen = generations_;
    for (uint generation = static_cast<uint>(levels_.size()); generation-- > 0;) {
        Level &here = levels_[generation];
        if (here.first == here.end) here.used = here.first = here.end = 0;  // nobody needs its slots any more
        if (here.used == 0 || room(generation) == 0) continue;
        chosen = generation;
        if (room(generation) >= full_launch_) break;
    }
    if (chosen == generations_) return std::nullopt;
    Level &here = levels_[chosen];
    const uint count = room(chosen);
    Wave wave{here, here.first, count, chosen, nullptr, 0};
    here.first += count;
    if (branching_ > 0 && chosen + 1 < generations_) {
        Level &below = level(chosen + 1);
        wave.children = &below;
        wave.base = below.used;
        below.used += count * branching_;
    }
    return wave;
}

void Levels::add_children(const Wave &wave, uint live) { wave.children->end += live; }

}  // namespace brandung
