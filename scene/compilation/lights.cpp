#include <algorithm>

#include "scene/compilation/parts.h"
#include "scene/lights/light_choices.h"
#include "scene/materials_in_use.h"
#include "scene/places.h"
#include "scene/warnings.h"

namespace brandung {
namespace {

void warn_of_opaque_shadows(const Scene &scene, CompiledScene &compiled) {
    compiled.warnings["transparent objects cast opaque shadows: --shadows filtered lets light through them"] = 1;
    const std::vector<bool> used = materials_in_use(scene);
    uint first = 0;
    while (!used[first] || (scene.materials[first].record.flags & MATERIAL_TRANSMITS) == 0) ++first;
    place_warnings(compiled, [&] { return place_of_material(scene, first); });
}

}  // namespace

void add_lights(const Scene &scene, CompiledScene &compiled, Arena &arena) {
    const LightRows lights = make_light_rows(scene);
    compiled.filters_shadows = !compiled.paths && scene.integrator.filtered_shadows && compiled.transmits;
    if (!compiled.paths && scene.integrator.shadows_unsaid && compiled.transmits && !lights.rows.empty()) warn_of_opaque_shadows(scene, compiled);
    compiled.lights = kinds_of(lights.rows);
    compiled.light_counts = lights.counts;
    compiled.dark_emitters = lights.dark;
    compiled.emissive_instances =
        std::any_of(lights.shapes.begin(), lights.shapes.end(), [](const PlacedShape &placed) { return placed.instance != 0; });
    compiled.header.emissive_faces = arena.add(lights.faces);
    compiled.header.lights = arena.add(lights.rows);
    if (!compiled.paths) return;
    const LightChoices choices = make_light_choices(lights, scene, compiled.header.world.extent);
    compiled.header.light_choices = arena.add(choices.choices);
    compiled.header.emission_chance = choices.emission;
    compiled.environment = choices.environment > 0;
    compiled.header.environment_rows = arena.add(lights.environment.rows);
    compiled.header.environment_begins = arena.add(lights.environment.begins);
    compiled.header.environment_marks = arena.add(lights.environment.marks);
    compiled.header.environment_row_count = lights.environment.row_count(), compiled.header.environment_columns = lights.environment.columns;
    compiled.header.environment_density = choices.environment;
}

}  // namespace brandung
