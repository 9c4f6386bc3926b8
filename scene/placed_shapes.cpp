#include "scene/placed_shapes.h"

namespace brandung {
namespace {

bool shines(const Scene &scene, uint material) { return scene.materials[material].record.emission != Spectrum(0); }

/// By their own materials.
std::vector<const Shape *> shining(const Scene &scene, const std::vector<std::unique_ptr<Shape>> &shapes) {
    std::vector<const Shape *> result;
    for (const auto &shape : shapes)
        if (shines(scene, shape->material)) result.push_back(shape.get());
    return result;
}

}  // namespace

std::vector<PlacedShape> emissive_shapes(const Scene &scene) {
    std::vector<PlacedShape> result;
    for (const Shape *shape : shining(scene, scene.shapes)) result.push_back({shape, 0, shape->material});
    std::vector<std::vector<const Shape *>> of_groups;
    for (const NamedGroup &group : scene.groups) of_groups.push_back(shining(scene, group.shapes));
    for (uint i = 0; i < scene.instances.size(); ++i) {
        const PlacedGroup &placed = scene.instances[i];
        if (placed.material == NO_MATERIAL) {
            for (const Shape *shape : of_groups[placed.group]) result.push_back({shape, i + 1, shape->material});
        } else if (shines(scene, placed.material)) {
            for (const auto &shape : scene.groups[placed.group].shapes) result.push_back({shape.get(), i + 1, placed.material});
        }
    }
    return result;
}

}  // namespace brandung
