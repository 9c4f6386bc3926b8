#include "scene/lights/enclosed_lights.h"

#include <algorithm>
#include <cstring>

#include "scene/lights/light.h"

namespace brandung {
namespace {

bool has_inside(const Bounds &bounds, vec3 p) { return glm::all(glm::lessThan(bounds.low, p)) && glm::all(glm::lessThan(p, bounds.high)); }

Bounds bounds_of(const Shape &shape) {
    Bounds bounds;
    for (std::size_t i = 0; i < shape.count(); ++i) bounds.add(shape.bounds(i));
    return bounds;
}

/// Where lights are, and the middles of emissive shapes.
std::vector<vec3> places_of_lights(const Scene &scene) {
    std::vector<vec3> places;
    for (const Light &light : scene.lights) {
        if (!light_kinds()[light.kind].has_position) continue;
        vec3 position;
        std::memcpy(&position, light.words, sizeof position);
        places.push_back(position);
    }
    for (const auto &shape : scene.shapes) {
        if (scene.materials[shape->material].record.emission == Spectrum(0)) continue;
        const Bounds bounds = bounds_of(*shape);
        places.push_back(0.5f * (bounds.low + bounds.high));
    }
    return places;
}

}  // namespace

uint count_enclosed_lights(const Scene &scene) {
    std::vector<Bounds> transparent;
    for (const auto &shape : scene.shapes) {
        const Material &material = scene.materials[shape->material].record;
        if ((material.flags & MATERIAL_TRANSMITS) != 0 && material.emission == Spectrum(0)) transparent.push_back(bounds_of(*shape));
    }
    const std::vector<vec3> places = places_of_lights(scene);
    return uint(std::count_if(places.begin(), places.end(), [&](vec3 place) {
        return std::any_of(transparent.begin(), transparent.end(), [&](const Bounds &bounds) { return has_inside(bounds, place); });
    }));
}

}  // namespace brandung
