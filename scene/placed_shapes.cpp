#include "scene/placed_shapes.h"

namespace brandung {
namespace {

using IsSuch = bool (*)(const Material &);

std::vector<const Shape *> such_of(const Scene &scene, const std::vector<std::unique_ptr<Shape>> &shapes, IsSuch is_such) {
    std::vector<const Shape *> result;
    for (const auto &shape : shapes)
        if (is_such(scene.materials[shape->material].record)) result.push_back(shape.get());
    return result;
}

}  // namespace

std::vector<PlacedShape> shapes_made_of(const Scene &scene, IsSuch is_such) {
    std::vector<PlacedShape> result;
    for (const Shape *shape : such_of(scene, scene.shapes, is_such)) result.push_back({shape, 0, shape->material});
    std::vector<std::vector<const Shape *>> of_groups;  // where their materials are their own
    for (const NamedGroup &group : scene.groups) of_groups.push_back(such_of(scene, group.shapes, is_such));
    for (uint i = 0; i < scene.instances.size(); ++i) {
        const PlacedGroup &placed = scene.instances[i];
        if (placed.material == NO_MATERIAL) {
            for (const Shape *shape : of_groups[placed.group]) result.push_back({shape, i + 1, shape->material});
        } else if (is_such(scene.materials[placed.material].record)) {
            for (const auto &shape : scene.groups[placed.group].shapes) result.push_back({shape.get(), i + 1, placed.material});
        }
    }
    return result;
}

Bounds bounds_of(const Scene &scene, const PlacedShape &placed) {
    Bounds bounds;
    for (std::size_t i = 0; i < placed.shape->count(); ++i) bounds.add(placed.shape->bounds(i));
    return placed.instance == 0 ? bounds : bounds_in_world(scene.instances[placed.instance - 1].transforms, bounds);
}

}  // namespace brandung
