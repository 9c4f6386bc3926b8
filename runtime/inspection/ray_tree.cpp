#include "runtime/inspection/ray_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "kernels/core/params.h"
#include "scene/vectors.h"

namespace brandung {
namespace {

/// The entries of item i.
std::vector<uint> media(const std::vector<uint> &lists, uint size, std::size_t i) {
    const auto first = lists.begin() + static_cast<std::ptrdiff_t>(i * size);
    return {first, first + size};
}

std::vector<TracedLightBlock> lights_of(const WaveRecords &wave, std::size_t i) {
    std::vector<TracedLightBlock> blocks;
    for (const LightBlockRecords &records : wave.lights) {
        TracedLightBlock &block = blocks.emplace_back();
        block.contribution = records.contributions[i];
        for (const LightRecords &light : records.lights) {
            const bool asked = light.asked[i] != 0, visible = light.visible[i] != 0;
            TracedLight &traced = block.lights.emplace_back(TracedLight{.row = light.rows[i],
                                                                        .ray = light.rays[i],
                                                                        .asked = asked,
                                                                        .visible = visible,
                                                                        .description = {},
                                                                        .chosen = {},
                                                                        .blocker = {},
                                                                        .filter = {},
                                                                        .passed = {},
                                                                        .radiance = light.radiance[i]});
            if (!light.filters.empty() && asked) traced.filter = light.filters[i];
            if (light.chosen.empty()) continue;
            const AskedDescription &chosen = traced.chosen.emplace(light.chosen[i]);
            traced.description = {chosen.irradiance, chosen.cosine, chosen.refusals};
        }
    }
    return blocks;
}

TracedRay traced_ray(const WaveRecords &wave, std::size_t i) {
    TracedRay ray{.path = wave.paths[i],
                  .begun = wave.begun[i],
                  .ray = wave.rays[i],
                  .hit = wave.hits[i],
                  .instance = wave.instances[i],
                  .begun_instance = wave.begun_instances[i],
                  .begun_media = media(wave.begun_media, wave.interior_size, i),
                  .passed = {},
                  .point = wave.points[i],
                  .interface = wave.interfaces[i],
                  .direction = wave.directions[i],
                  .before = media(wave.before, wave.interior_size, i),
                  .behind = media(wave.behind, wave.interior_size, i),
                  .unlit = wave.unlit[i],
                  .lights = lights_of(wave, i)};
    if (!wave.times.empty()) ray.time = wave.times[i];
    if (!wave.tints.empty()) ray.tints = wave.tints[i];
    if (!wave.met.empty()) ray.met = wave.met[i];
    for (const ChildRecords &child : wave.children) {
        ray.children.push_back({child.rays[i], child.weights[i], nullptr, {}});
        if (!child.chosen.empty()) ray.children.back().chosen = child.chosen[i];
        if (child.alive[i] != 0) ray.children.back().traced = std::make_unique<TracedRay>();
    }
    return ray;
}

}  // namespace

void add_place(std::vector<uint> &places, uint instance, const TracedRay &ray) {
    places.push_back(instance);
    if (ray.time) places.push_back(std::bit_cast<uint>(*ray.time));
}

RayTrees::RayTrees(uint samples) : trees_(samples), waiting_(1) {
    for (TracedRay &tree : trees_) waiting_[0].push_back(&tree);
}

void RayTrees::see(const WaveRecords &wave) {
    const std::size_t count = wave.count();
    waiting_.resize(std::max<std::size_t>(waiting_.size(), wave.generation + 2));
    std::vector<TracedRay *> &below = waiting_[wave.generation + 1];
    below.resize(std::max(below.size(), wave.base + wave.children.size() * count));
    for (std::size_t i = 0; i < count; ++i) {
        TracedRay &ray = *waiting_[wave.generation][wave.slots[i]];
        ray = traced_ray(wave, i);
        for (std::size_t j = 0; j < ray.children.size(); ++j) below[wave.base + j * count + i] = ray.children[j].traced.get();
        std::erase_if(ray.children, [](const TracedChild &child) { return child.chosen && (child.chosen->refusals & PATH_NO_PART) != 0; });
    }
}

uint surface_number(const TracedRay &ray) { return ray.path.depth & ((1u << SURFACE_BITS) - 1); }

SamplePart part_of_sample(const TracedRay &ray) {
    return {ray.path.depth >> SURFACE_BITS & (MAX_BUNDLE - 1), (ray.path.depth >> (SURFACE_BITS + PART_BITS)) + 1};
}

std::vector<TracedRay *> all_rays(std::vector<TracedRay> &trees) {
    std::vector<TracedRay *> rays, waiting;
    for (TracedRay &tree : trees) waiting.push_back(&tree);
    while (!waiting.empty()) {
        TracedRay *ray = waiting.back();
        waiting.pop_back();
        rays.push_back(ray);
        for (TracedChild &child : ray->children)
            if (child.traced) waiting.push_back(child.traced.get());
    }
    return rays;
}

FixedPoint fixed_point(Spectrum contribution) {
    if (!is_finite(contribution)) return {};
    const auto round = [](float x) { return static_cast<std::int64_t>(std::rint(std::clamp(x, -0x1p17f, 0x1p17f) * 0x1p32f)); };
    return {round(contribution.x), round(contribution.y), round(contribution.z)};
}

}  // namespace brandung
