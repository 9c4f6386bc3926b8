#include "runtime/integrators/observation.h"

#include <algorithm>
#include <bit>
#include <map>
#include <utility>

namespace brandung {
namespace {

/// The records at these slots, `size` for each.
template <class T> std::vector<T> gather(const Buffer<T> &buffer, const std::vector<uint> &slots, uint size = 1) {
    const std::vector<T> all = buffer.read();
    std::vector<T> items;
    for (const uint slot : slots)
        for (uint k = 0; k < size; ++k) items.push_back(all[std::size_t{slot} * size + k]);
    return items;
}

/// The words of places, without the times; 0 in scenes without instances.
std::vector<uint> instances_of(const std::vector<uint> &places, uint words, std::size_t count) {
    std::vector<uint> instances(count);
    for (std::size_t i = 0; words > 0 && i < count; ++i) instances[i] = places[i * words];
    return instances;
}

/// Empty in scenes where nothing moves.
std::vector<float> times_of(const std::vector<uint> &places, uint words) {
    std::vector<float> times;
    for (std::size_t i = 1; words == 2 && i < places.size(); i += 2) times.push_back(std::bit_cast<float>(places[i]));
    return times;
}

/// Places in `items`, of which there are `size` for each of these numbers.
template <class T> void permute(std::vector<T> &items, const std::vector<uint> &numbers, uint size = 1) {
    const std::vector<T> before = std::exchange(items, {});
    for (const uint number : numbers) {
        const auto first = before.begin() + std::ptrdiff_t{number} * size;
        items.insert(items.end(), first, first + size);
    }
}

}  // namespace

Observation::Observation(Device &device, uint batch, uint children, uint interior_size, uint place_words)
    : unit_paths(device, std::max(batch, children)),
      rays(device, std::size_t{batch} * children),
      paths(device, std::size_t{batch} * children),
      sources(device, std::size_t{batch} * children * place_words),
      interiors(device, std::size_t{batch} * children * interior_size),
      alive(device, std::size_t{batch} * children),
      all_visible(device, std::vector<std::uint8_t>(batch, 1)),
      arriving(device, batch),
      radiance(device, batch),
      children_(children),
      place_words_(place_words) {
    records.interior_size = interior_size;
}

void Observation::begin(const Wave &wave, bool coherent) {
    records = {.generation = wave.generation, .coherent = coherent, .base = wave.base, .interior_size = records.interior_size};
    records.slots = wave.level.live.read(wave.first, wave.count);
    records.begun = gather(wave.level.rays, records.slots);
    const std::vector<uint> sources = gather(wave.level.sources, records.slots, place_words_);
    records.begun_instances = instances_of(sources, place_words_, wave.count), records.times = times_of(sources, place_words_);
    if (records.interior_size > 0) records.begun_media = gather(wave.level.interiors, records.slots, records.interior_size);
    records.paths = gather(wave.level.paths, records.slots);
    std::vector<Path> unit = wave.level.paths.read();
    for (Path &path : unit) path.throughput = Spectrum(1);
    unit_paths.write(unit);
}

/// From the order in which the rays were traced to that in which the stages behind have left them.
void Observation::reorder(const Wave &wave) {
    const std::vector<uint> before = std::exchange(records.slots, wave.level.live.read(wave.first, wave.count));
    std::map<uint, uint> places;
    for (uint i = 0; i < wave.count; ++i) places[records.slots[i]] = i;
    std::vector<uint> numbers(wave.count);  // in the order before
    for (uint i = 0; i < wave.count; ++i) numbers[places.at(before[i])] = i, records.traced.push_back(places.at(before[i]));
    permute(records.begun, numbers), permute(records.begun_instances, numbers), permute(records.paths, numbers);
    if (!records.times.empty()) permute(records.times, numbers);
    if (records.interior_size > 0) permute(records.begun_media, numbers, records.interior_size);
}

void Observation::record_hits(const Wave &wave, const Buffer<Hit> &hits, const Buffer<uint> &instances, const Buffer<SurfacePoint> &points,
                              const Buffer<SurfaceInterface> &interfaces, const Buffer<vec3> &directions, const Buffer<uint> &beyond) {
    reorder(wave);
    records.rays = gather(wave.level.rays, records.slots);
    records.hits = hits.read(0, wave.count);
    records.instances = instances_of(instances.read(0, std::size_t{wave.count} * place_words_), place_words_, wave.count);
    records.points = points.read(0, wave.count);
    records.interfaces = interfaces.read(0, wave.count);
    records.directions = directions.read(0, wave.count);
    if (records.interior_size == 0) return;
    records.before = gather(wave.level.interiors, records.slots, records.interior_size);
    records.behind = beyond.read(0, std::size_t{wave.count} * records.interior_size);
}

void Observation::record_shadows(const Wave &wave, LightRecords &light, std::size_t slot, const Buffer<std::uint8_t> &visible,
                                 const Buffer<Spectrum> *filters) {
    light.visible = visible.read(slot, wave.count);
    if (filters) light.filters = filters->read(slot, wave.count);
    std::vector<Spectrum> parts(wave.count, Spectrum(1));
    for (uint i = 0; filters && i < wave.count; ++i)
        if (light.visible[i] != 0) parts[i] = light.filters[i];
    arriving.write(parts);
}

void Observation::record_children(const Buffer<std::uint8_t> *alive_below) {
    const std::size_t count = records.count();
    for (uint j = 0; j < children_; ++j) {
        ChildRecords &children = records.children.emplace_back();
        children.rays = rays.read(j * count, count);
        for (const Path &path : paths.read(j * count, count)) children.weights.push_back(path.throughput);
        children.alive = alive_below ? alive_below->read(j * count, count) : std::vector<std::uint8_t>(count, 0);
    }
}

}  // namespace brandung
