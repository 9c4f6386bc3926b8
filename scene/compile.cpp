#include "scene/compile.h"

#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "kernels/bsdfs/loss_table.h"
#include "scene/bsdfs/bsdf.h"
#include "scene/bsdfs/choosing.h"
#include "scene/compilation/parts.h"
#include "scene/compilation/sizes.h"
#include "scene/error.h"
#include "scene/filters/filter.h"
#include "scene/lights/light.h"
#include "scene/materials_in_use.h"
#include "scene/places.h"

namespace brandung {
namespace {

template <class KindsOfFamily> std::vector<uint> numbers_of(const KindsOfFamily &kinds) {
    std::vector<uint> numbers(kinds.size());
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
}

/// Of one that chooses, itself: its members are in use too.
bool is_whitted(const Material &material) { return chooses(material) ? !lets_light_pass(material) : bsdf_kinds()[material.kind].is_whitted; }

/// Of all materials in use.
void expect_whitted(const Scene &scene) {
    const std::vector<bool> used = materials_in_use(scene);
    for (uint m = 0; m < used.size(); ++m) {
        const Material &material = scene.materials[m].record;
        if (!used[m] || is_whitted(material)) continue;
        const std::string place = place_of_material(scene, m);
        throw SceneError(fmt::format("{}: integrator whitted cannot show a material of type \"{}\"; --integrator path can",
                                     place.empty() ? scene.file : place, type_of(material)));
    }
}

/// As if the scene used whatever changes no picture by being there.
void use_everything(const Scene &scene, CompiledScene &compiled, Arena &arena) {
    compiled.bsdfs = numbers_of(bsdf_kinds()), compiled.lights = numbers_of(light_kinds());
    compiled.moves = compiled.reflects = compiled.transmits = compiled.chooses = compiled.emissive_instances = compiled.environment =
        compiled.highlights = compiled.shading_normals = compiled.tints = true;
    compiled.facets = 3;
    if (!std::exchange(compiled.losses, true)) arena.make(sizeof(LossTable), 0);  // kernels read what is behind materials
    compiled.bundles = compiled.paths;
    compiled.filters_shadows = !compiled.paths && scene.integrator.filtered_shadows;
    compiled.interior_size = max_interior_size;
}

}  // namespace

CompiledScene compile(const Scene &scene, const CompileOptions &options) {
    CompiledScene compiled;
    compiled.warnings = scene.warnings;
    compiled.warning_places = scene.warning_places;
    compiled.paths = scene.integrator.traces_paths();
    if (scene.integrator.type == "whitted") expect_whitted(scene);
    Arena arena(compiled.arena);
    add_primitives(scene, options, compiled, arena);
    add_materials(scene, options, compiled, arena);
    add_lights(scene, compiled, arena);
    expect_to_fit(scene, compiled, options.limit);
    if (options.kinds == Kinds::all) use_everything(scene, compiled, arena);
    compiled.filter = splats(scene.film) ? 0 : scene.film.filter;
    compiled.sampler = scene.film.sampler;
    compiled.header.background = scene.background;
    compiled.header.ambient = scene.ambient;
    return compiled;
}

}  // namespace brandung
