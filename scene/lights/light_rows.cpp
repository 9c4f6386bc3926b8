#include "scene/lights/light_rows.h"

#include "scene/lights/light.h"
#include "scene/materials_in_use.h"

namespace brandung {
namespace {

bool shows_light(const Scene &scene) {
    const std::vector<bool> used = materials_in_use(scene);
    for (std::size_t m = 0; m < used.size(); ++m)
        if (used[m] && (scene.materials[m].record.flags & MATERIAL_LIT) != 0) return true;
    return false;
}

/// Paths ask one light at a surface, chosen among all faces; else each surface asks every one of samples * samples cells.
std::vector<Light> cells_of(const Shape &shape, bool paths, uint samples, std::vector<EmissiveFace> &faces) {
    std::vector<Light> flat;
    if (paths) flat = shape.flat_lights();
    return flat.empty() ? shape.light(paths ? 1 : samples, faces) : flat;
}

void add_environment(const Scene &scene, LightRows &lights) {
    lights.environment = make_environment(scene.textures[scene.background_texture - 1].picture, scene.background);
    if (lights.environment.rows.empty()) return;
    lights.rows.push_back(make_light(Environment{lights.environment.radiance}));
    lights.shapes.resize(lights.rows.size());
    ++lights.counts["environment"];
}

}  // namespace

LightRows make_light_rows(const Scene &scene) {
    LightRows lights;
    lights.rows = scene.lights;
    lights.shapes.resize(scene.lights.size());
    for (const Light &light : scene.lights) ++lights.counts[light_kinds()[light.kind].name];
    if (!shows_light(scene)) return lights;
    const std::vector<PlacedShape> emissive = emissive_shapes(scene);
    const bool paths = scene.integrator.traces_paths();
    const uint samples = scene.integrator.light_samples;
    if (samples == 0) {
        lights.dark = uint(emissive.size());
        return lights;
    }
    std::map<const Shape *, std::vector<Light>> made;  // instances share faces
    for (const PlacedShape &placed : emissive) {
        const auto [cells, is_new] = made.try_emplace(placed.shape);
        if (is_new) cells->second = cells_of(*placed.shape, paths, samples, lights.faces);
        ++lights.counts[light_kinds()[cells->second.front().kind].name];
        append_cells(cells->second, scene.materials[placed.material].record, placed.instance, lights.rows);
        lights.shapes.resize(lights.rows.size(), placed);
    }
    if (paths && scene.background_texture != 0) add_environment(scene, lights);
    return lights;
}

}  // namespace brandung
