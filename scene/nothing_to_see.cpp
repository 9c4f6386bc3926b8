#include "scene/nothing_to_see.h"

#include "kernels/bsdfs/whitted.h"
#include "scene/bsdfs/bsdf.h"
#include "scene/bsdfs/choosing.h"
#include "scene/kinds.h"
#include "scene/materials_in_use.h"
#include "scene/places.h"
#include "scene/vectors.h"
#include "scene/warnings.h"

namespace brandung {
namespace {

/// What the materials in use can show, each being one of those of `seen`.
struct Surfaces {
    std::vector<uint> seen;
    bool shine = false, lit = false, ambient = false,
         pass_on = false;  ///< whether any does: of itself, of lights, of ambient light, of what is behind
};

bool reflects_ambient_light(const Material &material) {
    return bsdf_kinds()[material.kind].is_whitted && largest(view_of<Whitted>(material.words).ambient) > 0;
}

Surfaces surfaces_of(const Scene &scene) {
    const std::vector<bool> used = materials_in_use(scene);
    Surfaces surfaces;
    for (uint m = 0; m < used.size(); ++m) {
        if (!used[m]) continue;
        const Material &material = scene.materials[m].record;
        surfaces.pass_on |= lets_light_pass(material);
        if (chooses(material)) continue;  // its members are seen
        surfaces.seen.push_back(m);
        surfaces.shine |= largest(material.emission) > 0;
        surfaces.lit |= (material.flags & MATERIAL_LIT) != 0;
        surfaces.ambient |= reflects_ambient_light(material);
        surfaces.pass_on |= (material.flags & MATERIAL_IDEAL) != 0;
    }
    return surfaces;
}

void warn_of_black_objects(Scene &scene) {
    const Surfaces surfaces = surfaces_of(scene);
    const bool paths = scene.integrator.traces_paths();
    const bool has_lights = !scene.lights.empty(), has_background = largest(scene.background) > 0;
    const bool has_ambient = !paths && largest(scene.ambient) > 0;
    const bool is_lit = has_lights || (has_background && paths);
    if (surfaces.shine || (surfaces.lit && is_lit) || (surfaces.ambient && has_ambient) || (surfaces.pass_on && has_background)) return;
    if (!has_lights && !has_ambient) {
        ++scene.warnings["the scene has neither lights nor ambient light nor emission: its objects are black"];
        return place_warnings(scene, [&] { return scene.file; });
    }
    const bool blank = !surfaces.lit && !surfaces.ambient && !surfaces.pass_on;
    scene.warnings[blank ? "material that reflects, lets through and emits nothing, as all that are seen: the objects are black"
                         : "material that shows nothing of the scene's light, as all that are seen: the objects are black"] =
        uint(surfaces.seen.size());
    place_warnings(scene, [&] { return place_of_material(scene, surfaces.seen.front()); });
}

}  // namespace

void warn_of_nothing_to_see(Scene &scene) {
    if (!scene.shapes.empty() || !scene.instances.empty()) return warn_of_black_objects(scene);
    ++scene.warnings["the scene has no objects"];
    place_warnings(scene, [&] { return scene.file; });
}

}  // namespace brandung
