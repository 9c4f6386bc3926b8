#include "runtime/inspection/list_faces.h"

#include <algorithm>

#include "runtime/opencl/kernel.h"

namespace brandung {
namespace {

using Faces = std::vector<PassedFace>;

/// The faces of `count` rays, by `list(capacity, counts, faces)`, which is called again if there are more than it had room for.
template <class List> std::vector<Faces> faces_by(Device &device, std::size_t count, List list) {
    for (uint capacity = 8;;) {
        const Buffer<uint> counts(device, count);
        const Buffer<PassedFace> faces(device, count * capacity);
        list(capacity, counts, faces);
        const std::vector<uint> numbers = counts.read();
        const uint most = *std::max_element(numbers.begin(), numbers.end());
        if (most > capacity) {
            capacity = most;
            continue;
        }
        const std::vector<PassedFace> all = faces.read();
        std::vector<Faces> lists;
        for (std::size_t i = 0; i < count; ++i) {
            const auto first = all.begin() + static_cast<std::ptrdiff_t>(i * capacity);
            lists.emplace_back(first, first + numbers[i]);
        }
        return lists;
    }
}

void list_passed_faces(Device &device, const DeviceScene &scene, const std::vector<TracedRay *> &traced) {
    std::vector<TracedRay *> passing;
    std::vector<Ray> rays;
    std::vector<uint> sources, interiors;
    for (TracedRay *ray : traced) {
        if (!ray->passed_faces()) continue;
        passing.push_back(ray), rays.push_back(ray->begun), add_place(sources, ray->begun_instance, *ray);
        interiors.insert(interiors.end(), ray->begun_media.begin(), ray->begun_media.end());
    }
    if (passing.empty()) return;

    Kernel list(device, "kernels/stages/list_passed_faces.cl", "list_passed_faces", scene.lists());
    const Buffer<uint> lost(device, 1);
    const std::vector<Faces> lists = faces_by(device, rays.size(), [&](uint capacity, const Buffer<uint> &counts, const Buffer<PassedFace> &faces) {
        list(rays.size(), scene, Buffer<Ray>(device, rays), Buffer<uint>(device, sources), Buffer<uint>(device, interiors),
             static_cast<uint>(rays.size()), capacity, lost, counts, faces);
    });
    for (std::size_t i = 0; i < passing.size(); ++i) passing[i]->passed = lists[i];
}

/// The last face of a ray on which nothing arrives is what blocks it.
void set_faces(TracedLight &light, Faces faces) {
    if (!light.visible) {
        light.blocker = faces.back().hit, light.blocker_instance = faces.back().instance;
        faces.pop_back();
    }
    light.passed = std::move(faces);
}

void list_shadow_faces(Device &device, const DeviceScene &scene, const std::vector<TracedRay *> &traced) {
    std::vector<TracedLight *> filtered;
    std::vector<Ray> rays;
    std::vector<uint> sources;
    for_each_light(traced, [&](const TracedRay &ray, TracedLight &light) {
        if (light.filter) filtered.push_back(&light), rays.push_back(light.ray), add_place(sources, ray.instance, ray);
    });
    if (filtered.empty()) return;

    Kernel list(device, "kernels/stages/list_shadow_faces.cl", "list_shadow_faces", scene.lists());
    const std::vector<Faces> lists = faces_by(device, rays.size(), [&](uint capacity, const Buffer<uint> &counts, const Buffer<PassedFace> &faces) {
        list(rays.size(), scene, Buffer<Ray>(device, rays), Buffer<uint>(device, sources), static_cast<uint>(rays.size()), capacity, counts, faces);
    });
    for (std::size_t i = 0; i < filtered.size(); ++i) set_faces(*filtered[i], lists[i]);
}

}  // namespace

void list_faces(Device &device, const DeviceScene &scene, std::vector<TracedRay> &trees) {
    const std::vector<TracedRay *> traced = all_rays(trees);
    list_passed_faces(device, scene, traced);
    list_shadow_faces(device, scene, traced);
}

}  // namespace brandung
