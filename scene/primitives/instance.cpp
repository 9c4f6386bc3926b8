/// Groups and their instances.
#include "kernels/primitives/instance.h"

#include <algorithm>

#include "scene/parameters.h"
#include "scene/primitives/add.h"

namespace brandung {
namespace {

bool in_range(const Bounds &bounds) {
    const vec3 farthest = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
    return std::max({farthest.x, farthest.y, farthest.z}) <= float(max_magnitude);
}

}  // namespace

uint add_group(Scene &scene, std::string name, std::vector<std::unique_ptr<Shape>> shapes) {
    NamedGroup &group = scene.groups.emplace_back(NamedGroup{std::move(name), std::move(shapes), {}});
    for (const auto &shape : group.shapes)
        for (std::size_t i = 0; i < shape->count(); ++i) group.bounds.add(shape->bounds(i));
    return uint(scene.groups.size() - 1);
}

std::optional<std::string> add_instance(Scene &scene, uint group, const AffineMap &map, uint material) {
    const std::optional<TransformPair> transforms = make_transforms(map);
    if (!transforms) return "is singular, or it or its inverse has numbers beyond 1e15";
    const Bounds &bounds = scene.groups.at(group).bounds;
    if (bounds.empty()) {
        ++scene.warnings["instance of a group without surfaces: left out"];
        return {};
    }
    const Bounds in_world = bounds_in_world(*transforms, bounds);
    if (!in_range(in_world)) return "places the group beyond 1e15";
    scene.instances.push_back({group, *transforms, in_world, material, NO_OBJECT});
    return {};
}

}  // namespace brandung
