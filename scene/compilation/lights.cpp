#include <algorithm>

#include "scene/compilation/parts.h"
#include "scene/lights/light_rows.h"

namespace brandung {

void add_lights(const Scene &scene, CompiledScene &compiled, Arena &arena) {
    const LightRows lights = make_light_rows(scene);
    compiled.filters_shadows = scene.integrator.filtered_shadows && compiled.transmits;
    if (scene.integrator.shadows_unsaid && compiled.transmits && !lights.rows.empty())
        compiled.warnings["transparent objects cast opaque shadows: --shadows filtered lets light through them"] = 1;
    compiled.lights = kinds_of(lights.rows);
    compiled.light_counts = lights.counts;
    compiled.dark_emitters = lights.dark;
    compiled.emissive_instances =
        std::any_of(lights.shapes.begin(), lights.shapes.end(), [](const PlacedShape &placed) { return placed.instance != 0; });
    compiled.header.emissive_faces = arena.add(lights.faces);
    compiled.header.lights = arena.add(lights.rows);
}

}  // namespace brandung
