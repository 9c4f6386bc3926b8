#include "runtime/inspection/describe_hits.h"

#include <numeric>

#include "runtime/opencl/kernel.h"

namespace brandung {
namespace {

void describe(Device &device, const DeviceScene &scene, const std::vector<TracedRay *> &traced) {
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    std::vector<uint> instances, materials;
    std::vector<float> etas;
    std::vector<TracedRay *> hitting;
    for (TracedRay *ray : traced) {
        if (!ray->hits()) continue;
        hitting.push_back(ray);
        rays.push_back(ray->ray), hits.push_back(ray->hit);
        add_place(instances, ray->instance, *ray), etas.push_back(ray->interface.eta);
        materials.push_back(ray->point.material);
    }
    if (hitting.empty()) return;

    Kernel describe(device, "kernels/stages/describe_hits.cl", "describe_hits", scene.lists());
    const std::size_t count = hitting.size();
    const Buffer<HitDescription> descriptions(device, count);
    describe(count, scene, Buffer<Ray>(device, rays), Buffer<Hit>(device, hits), Buffer<uint>(device, instances), Buffer<float>(device, etas),
             Buffer<uint>(device, materials), static_cast<uint>(count), descriptions);
    const std::vector<HitDescription> read = descriptions.read();
    for (std::size_t i = 0; i < count; ++i) hitting[i]->description = read[i];
}

void describe_lights(Device &device, const DeviceScene &scene, const std::vector<TracedRay *> &traced) {
    std::vector<TracedLight *> silent;
    std::vector<SurfacePoint> points;
    std::vector<uint> branches, instances, rows;
    for_each_light(traced, [&](const TracedRay &ray, TracedLight &light) {
        if (light.asked || light.chosen) return;
        silent.push_back(&light), points.push_back(ray.point), add_place(instances, ray.instance, ray);
        branches.push_back(ray.path.branch), rows.push_back(light.row);
    });
    if (silent.empty()) return;

    Kernel describe(device, "kernels/stages/describe_lights.cl", "describe_lights", scene.lists());
    const std::size_t count = silent.size();
    const Buffer<LightDescription> descriptions(device, count);
    describe(count, scene, Buffer<SurfacePoint>(device, points), Buffer<uint>(device, branches), Buffer<uint>(device, instances),
             Buffer<uint>(device, rows), static_cast<uint>(count), descriptions);
    const std::vector<LightDescription> read = descriptions.read();
    for (std::size_t i = 0; i < count; ++i) silent[i]->description = read[i];
}

/// Visibility needs any hit: which is the closest is found out here.
void find_blockers(Device &device, const DeviceScene &scene, const std::vector<TracedRay *> &traced) {
    std::vector<TracedLight *> blocked;
    std::vector<Ray> rays;
    std::vector<uint> sources;
    for_each_light(traced, [&](const TracedRay &ray, TracedLight &light) {
        if (light.asked && !light.visible && !light.filter)
            blocked.push_back(&light), rays.push_back(light.ray), add_place(sources, ray.instance, ray);
    });
    if (blocked.empty()) return;

    const std::size_t count = rays.size();
    std::vector<uint> all(count);
    std::iota(all.begin(), all.end(), 0u);
    Kernel intersect(device, "kernels/stages/intersect.cl", "intersect", scene.lists());
    const Buffer<Hit> hits(device, count);
    Buffer<uint> instances(device, sources.size());
    instances.fill_zero();
    const Buffer<std::uint8_t> crowded(device, count);
    Buffer<Tally> tallies(device, intersect.work_items(count));
    tallies.fill_zero();
    intersect(count, scene, Buffer<uint>(device, all), 0u, static_cast<uint>(count), Buffer<Ray>(device, rays), Buffer<uint>(device, sources), hits,
              instances, crowded, tallies);
    const std::vector<Hit> read = hits.read();
    const std::vector<uint> read_instances = instances.read();
    for (std::size_t i = 0; i < count; ++i)
        blocked[i]->blocker = read[i], blocked[i]->blocker_instance = read_instances[i * (sources.size() / count)];
}

}  // namespace

void describe_hits(Device &device, const DeviceScene &scene, std::vector<TracedRay> &trees) {
    const std::vector<TracedRay *> traced = all_rays(trees);
    describe(device, scene, traced);
    describe_lights(device, scene, traced);
    find_blockers(device, scene, traced);
}

}  // namespace brandung
