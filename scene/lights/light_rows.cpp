#include "scene/lights/light_rows.h"

#include <algorithm>

#include "scene/lights/light.h"

namespace brandung {
namespace {

bool shows_light(const Scene &scene) {
    return std::any_of(scene.shapes.begin(), scene.shapes.end(),
                       [&](const auto &shape) { return (scene.materials[shape->material].record.flags & MATERIAL_LIT) != 0; });
}

}  // namespace

LightRows make_light_rows(const Scene &scene) {
    LightRows lights;
    lights.rows = scene.lights;
    for (const Light &light : scene.lights) ++lights.counts[light_kinds()[light.kind].name];
    if (!shows_light(scene)) return lights;
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
    }
    return lights;
}

}  // namespace brandung
