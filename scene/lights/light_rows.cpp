#include "scene/lights/light_rows.h"

#include <algorithm>

#include "scene/compile.h"
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
    for (const PlacedGroup &placed : scene.instances)
        for (const auto &shape : scene.groups[placed.group].shapes) {
            const uint material = placed.material == NO_MATERIAL ? shape->material : placed.material;
            lights.in_groups += scene.materials[material].record.emission != Spectrum(0);
        }
    for (const auto &shape : scene.shapes) {
        const Spectrum radiance = scene.materials[shape->material].record.emission;
        if (radiance == Spectrum(0)) continue;
        if (scene.integrator.light_samples == 0) {
            ++lights.dark;
            continue;
        }
        const Light light = shape->light(radiance, lights.faces);
        ++lights.counts[light_kinds()[light.kind].name];
        append_strata(light, scene.integrator.light_samples, lights.rows);
        lights.shapes.resize(lights.rows.size(), shape.get());
    }
    return lights;
}

}  // namespace brandung
