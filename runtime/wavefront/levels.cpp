#include "runtime/wavefront/levels.h"

#include <algorithm>

namespace brandung {
namespace {

/// Smaller launches leave a device half idle.
constexpr uint worthwhile_launch = 16384;

}  // namespace

Levels::Levels(Device &device, uint batch, Branching branching, uint generations, SideArrays sides, WatchSteps on_step)
    : device_(device),
      batch_(batch),
      branching_(branching),
      capacity_(std::max({batch, branching.first, branching.others})),
      generations_(generations),
      full_launch_(std::min(batch, worthwhile_launch)),
      sides_(sides),
      level_bytes_(capacity_ * (sizeof(Ray) + sizeof(Path) + sizeof(uint) * (1 + sides.interior_size + sides.place_words + (sides.pdfs ? 1 : 0)))),
      on_step_(std::move(on_step)) {}

Level &Levels::level(uint generation) {
    while (levels_.size() <= generation) levels_.emplace_back(device_, capacity_, sides_);
    return levels_[generation];
}

Level &Levels::start(uint count) {
    for (Level &level : levels_) level.used = level.first = level.end = 0;
    Level &first = level(0);
    first.used = first.end = count;
    return first;
}

uint Levels::wave_size(uint generation) const {
    const uint children = generation + 1 == generations_ ? 0 : branching(generation);
    return std::min(batch_, capacity_ / std::max(children, 1u));
}

/// How many items of a level can be worked on, given the free slots below.
uint Levels::room(uint generation) {
    const Level &here = levels_[generation];
    const uint waiting = here.end - here.first;
    if (branching(generation) == 0 || generation + 1 == generations_) return std::min(waiting, batch_);
    const uint free = generation + 1 < levels_.size() ? capacity_ - levels_[generation + 1].used : capacity_;
    return std::min({waiting, batch_, free / branching(generation)});
}

/// The generation that the next wave is taken from, `generations_` if nothing waits.
uint Levels::choose() {
    uint chosen = generations_;
    for (uint generation = static_cast<uint>(levels_.size()); generation-- > 0;) {
        Level &here = levels_[generation];
        if (here.first == here.end) here.used = here.first = here.end = 0;  // nobody needs its slots any more
        if (here.used == 0 || room(generation) == 0) continue;
        chosen = generation;
        if (room(generation) >= full_launch_) break;
    }
    return chosen;
}

void Levels::tell_step(uint generation, uint count) const {
    WaveStep step{generation, count, {}};
    for (const Level &level : levels_) step.waiting.push_back(level.end - level.first);
    on_step_(step);
}

std::optional<Wave> Levels::next() {
    const uint chosen = choose(), count = chosen == generations_ ? 0 : room(chosen);
    if (on_step_) tell_step(count > 0 ? chosen : 0, count);
    if (count == 0) return std::nullopt;
    Level &here = levels_[chosen];
    Wave wave{here, here.first, count, chosen, nullptr, 0};
    here.first += count;
    if (branching(chosen) > 0 && chosen + 1 < generations_) {
        Level &below = level(chosen + 1);
        wave.children = &below;
        wave.base = below.used;
        below.used += count * branching(chosen);
    }
    return wave;
}

void Levels::add_children(const Wave &wave, uint live) { wave.children->end += live; }

}  // namespace brandung
