#include <algorithm>

#include "scene/compilation/parts.h"
#include "scene/lights/enclosed_lights.h"
#include "scene/lights/light_rows.h"

namespace brandung {

void add_lights(const Scene &scene, CompiledScene &compiled, Arena &arena) {
    compiled.filters_shadows = scene.integrator.filtered_shadows && compiled.transmits;
    if (const uint enclosed = compiled.filters_shadows ? 0 : count_enclosed_lights(scene))
        compiled.warnings
            ["light inside a transparent object: shadows are opaque, so that it lights nothing outside; --shadows filtered lets it through"] +=
            enclosed;
    const LightRows lights = make_light_rows(scene);
    compiled.lights = kinds_of(lights.rows);
    compiled.light_counts = lights.counts;
    compiled.dark_emitters = lights.dark;
    compiled.emitters_in_groups = lights.in_groups;
    if (lights.in_groups > 0) compiled.warnings["emissive shape in a group: is seen, but lights nothing"] = lights.in_groups;
    compiled.header.emissive_faces = arena.add(lights.faces);
    compiled.header.lights = arena.add(lights.rows);
}

}  // namespace brandung
