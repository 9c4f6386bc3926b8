/// Scenes of which it is known what they use.
#pragma once
#include "scene/filters/filter.h"
#include "scene/kinds.h"
#include "tests/support/primitives.h"
#include "tests/support/scenes.h"

namespace brandung {

inline Scene scene_with(const Material &material) {
    Scene scene;
    scene.cameras.push_back({.name = "camera", .from = {0, 0, 5}, .at = {0, 0, 0}});
    scene.film.width = scene.film.height = 8;
    add_material(scene, material);
    return scene;
}

inline Scene spheres_only(const Material &material) {
    Scene scene = scene_with(material);
    add_sphere(scene, 0, {0, 0, 0}, 1);
    scene.lights.push_back(point_light({3, 3, 3}, Spectrum(10)));
    return scene;
}

inline Scene triangles_only(const Material &material) {
    Scene scene = scene_with(material);
    add_triangle(scene, 0, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
    scene.lights.push_back(directional_light({0, 0, 1}, Spectrum(1)));
    return scene;
}

/// But instances.
inline Scene everything() {
    Scene scene = spheres_only(glass(1.5f));
    scene.integrator.filtered_shadows = true;
    add_soup(scene, 0, {.of_each = 1});
    scene.lights.push_back(directional_light({0, 0, 1}, Spectrum(1)));
    scene.lights.push_back(spot_light({0, 0, 3}, {0, 0, 0}, Spectrum(1), 40, 0.2));
    Material lamp = matte(0.5f);
    lamp.emission = Spectrum(1);
    add_soup(scene, add_material(scene, lamp), {.of_each = 1});
    scene.film.filter = kind_number(filter_kinds(), "gaussian");
    scene.textures.push_back({"", {}, {1, 1, {Spectrum(1)}, {}}});
    scene.background_texture = 1;
    return scene;
}

}  // namespace brandung
