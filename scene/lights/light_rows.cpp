#include "scene/lights/light_rows.h"

#include <algorithm>

#include "scene/lights/light.h"

namespace brandung {
namespace {

bool shows_light(const Scene &scene) {
    const auto is_lit = [&](const auto &shape) { return (scene.materials[shape->material].record.flags & MATERIAL_LIT) != 0; };
    const auto any_lit = [&](const auto &shapes) { return std::any_of(shapes.begin(), shapes.end(), is_lit); };
    const auto instance_lit = [&](const PlacedGroup &placed) {
        return placed.material != NO_MATERIAL ? (scene.materials[placed.material].record.flags & MATERIAL_LIT) != 0
                                              : any_lit(scene.groups[placed.group].shapes);
    };
    return any_lit(scene.shapes) || std::any_of(scene.instances.begin(), scene.instances.end(), instance_lit);
}

}  // namespace

LightRows make_light_rows(const Scene &scene) {
    LightRows lights;
    lights.rows = scene.lights;
    lights.shapes.resize(scene.lights.size());
    for (const Light &light : scene.lights) ++lights.counts[light_kinds()[light.kind].name];
    if (!shows_light(scene)) return lights;
    const std::vector<PlacedShape> emissive = emissive_shapes(scene);
    const uint samples = scene.integrator.light_samples;
    if (samples == 0) {
        lights.dark = uint(emissive.size());
        return lights;
    }
    std::map<const Shape *, std::vector<Light>> made;  // instances share faces
    for (const PlacedShape &placed : emissive) {
        const auto [cells, is_new] = made.try_emplace(placed.shape);
        if (is_new) cells->second = placed.shape->light(samples, lights.faces);
        ++lights.counts[light_kinds()[cells->second.front().kind].name];
        append_cells(cells->second, scene.materials[placed.material].record.emission, placed.instance, lights.rows);
        lights.shapes.resize(lights.rows.size(), placed);
    }
    return lights;
}

}  // namespace brandung
