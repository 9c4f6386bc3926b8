#include "tests/support/traced_scene.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "tests/support/probe.h"

namespace brandung {
namespace {

CompiledScene compile_with(Scene &scene, const std::string &accelerator) {
    scene.accelerator = accelerator;
    return compile(scene);
}

/// A live list with `unused` entries in front of those that count, so that `first` matters; these are rays from the last to the first, so that a
/// ray's place in the list is not its number.
constexpr uint unused = 3;

std::vector<uint> live_list(std::size_t count) {
    std::vector<uint> live(unused + count, 0);
    std::iota(live.rbegin(), live.rend() - unused, 0u);
    return live;
}

template <class T> std::vector<T> reversed(std::vector<T> values) {
    std::ranges::reverse(values);
    return values;
}

/// As many as there are rays.
std::vector<uint> resized(std::vector<uint> numbers, std::size_t count) {
    numbers.resize(count, numbers.empty() ? 0 : numbers.back());
    return numbers;
}

Tally sum_of(const Buffer<Tally> &tallies) {
    Tally sum{};
    for (const Tally &tally : tallies.read())
        for (uint kind = 0; kind < RAY_KINDS; ++kind) sum.rays[kind] += tally.rays[kind], sum.hits[kind] += tally.hits[kind];
    return sum;
}

}  // namespace

Ray make_ray(vec3 origin, vec3 direction, float t_max, uint kind) {
    return {.origin = origin, .t_max = t_max, .direction = direction, .tag = RAY_TAG(kind, NO_HIT)};
}

TracedScene::TracedScene(Scene &scene, const std::string &accelerator) : TracedScene(compile_with(scene, accelerator)) {}

TracedScene::TracedScene(CompiledScene compiled) : compiled_(std::move(compiled)), on_device_(test_device(), compiled_) {}

std::vector<Hit> TracedScene::closest_hits(const Traversal &traversal, const std::vector<Ray> &rays) {
    Device &device = test_device();
    Kernel kernel = traversal_kernel(device, traversal, &Traversal::closest_hit, compiled_);
    const Buffer<Ray> ray_buffer(device, reversed(rays));
    const Buffer<uint> live(device, live_list(rays.size()));
    const Buffer<Hit> hits(device, rays.size());
    const Buffer<uint> sources(device, reversed(resized(sources_, rays.size())));
    const Buffer<uint> instances(device, std::vector<uint>(rays.size(), 0));
    const Buffer<std::uint8_t> crowded(device, rays.size());
    const Buffer<Tally> tallies(device, std::vector<Tally>(kernel.work_items(rays.size())));
    kernel(rays.size(), on_device_, live, unused, static_cast<uint>(rays.size()), ray_buffer, sources, hits, instances, crowded, tallies);
    tally_ = sum_of(tallies);
    instances_ = instances.read();
    if (compiled_.interior_size > 0) crowded_ = crowded.read();
    return hits.read();
}

std::vector<std::uint8_t> TracedScene::visible(const Traversal &traversal, const std::vector<Ray> &rays) {
    Device &device = test_device();
    Kernel kernel = traversal_kernel(device, traversal, &Traversal::any_hit, compiled_);
    const Buffer<Ray> ray_buffer(device, rays);
    std::vector<uint> all(rays.size());
    std::iota(all.begin(), all.end(), 0u);
    const Buffer<uint> live(device, all);
    const uint count = static_cast<uint>(rays.size());
    const Buffer<uint> counts(device, std::span(&count, 1));
    const Buffer<uint> sources(device, resized(sources_, rays.size()));
    const Buffer<std::uint8_t> visible(device, std::vector<std::uint8_t>(rays.size(), 1));
    const Buffer<Tally> tallies(device, std::vector<Tally>(kernel.work_items(rays.size())));
    kernel(rays.size(), on_device_, live, counts, count, ray_buffer, sources, visible, tallies);
    tally_ = sum_of(tallies);
    return visible.read();
}

std::vector<Traversal> TracedScene::traversals() const {
    std::vector<Traversal> available;
    for (const Traversal &traversal : brandung::traversals())
        if (is_available(traversal, test_device().info(), compiled_)) available.push_back(traversal);
    return available;
}

std::vector<Surface> TracedScene::surfaces(const std::vector<Ray> &rays, const std::vector<Hit> &hits, const std::vector<uint> &instances) {
    Device &device = test_device();
    Sources sources = on_device_.lists();
    sources["surfaces.cl"] = R"(#include "kernels/primitives/primitive.cl"
#include "generated/instances.cl"
        kernel void surfaces(SCENE_PARAMS, uint count, const global Ray *rays, const global Hit *hits, const global uint *instances,
                             global Surface *surfaces) {
            const Scene scene = SCENE;
            const uint i = get_global_id(0);
            if (i >= count || hits[i].primitive == NO_HIT) return;
            const ShadingRecord record = SCENE_ARRAY(scene, ShadingRecord, shading)[hits[i].primitive];
            const Ray ray = ray_in_group(scene, instance_at(instances, i), rays[i]);
            surfaces[i] = surface_in_world(scene, instance_at(instances, i), primitive_surface(scene, record, ray, hits[i]));
        })";
    Kernel kernel(device, "surfaces.cl", "surfaces", sources, 1);
    const Buffer<Ray> ray_buffer(device, rays);
    const Buffer<Hit> hit_buffer(device, hits);
    const Buffer<uint> instance_buffer(device, resized(instances, rays.size()));
    Buffer<Surface> surfaces(device, rays.size());
    surfaces.fill_zero();
    kernel(rays.size(), on_device_, static_cast<uint>(rays.size()), ray_buffer, hit_buffer, instance_buffer, surfaces);
    return surfaces.read();
}

}  // namespace brandung
