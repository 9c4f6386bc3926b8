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

/// Counts it, if so.
bool is_left_out(Scene &scene, uint group) {
    const bool empty = scene.groups.at(group).bounds.empty();
    if (empty) ++scene.warnings["instance of a group without surfaces: left out"];
    return empty;
}

std::optional<std::string> add_in_range(Scene &scene, PlacedGroup placed) {
    if (!in_range(placed.bounds)) return "places the group beyond 1e15";
    scene.instances.push_back(std::move(placed));
    return {};
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
    if (is_left_out(scene, group)) return {};
    return add_in_range(scene, {group, *transforms, bounds_in_world(*transforms, scene.groups[group].bounds), material});
}

std::optional<std::string> add_instance(Scene &scene, uint group, const Motion &motion, uint material) {
    if (auto fault = motion.fault()) return fault;
    if (motion.is_at_rest(scene.shutter)) return add_instance(scene, group, motion.at(scene.shutter.open), material);
    if (is_left_out(scene, group)) return {};
    const Bounds &bounds = scene.groups[group].bounds;
    auto parts = motion_parts(motion, scene.shutter, bounds);
    const std::optional<TransformPair> first = make_transforms(motion.at(scene.shutter.open));
    if (!parts || !first) return "changes too much between its keys";
    return add_in_range(scene, {group, *first, bounds_in_world(*parts, bounds), material, NO_OBJECT, std::move(*parts)});
}

}  // namespace brandung
