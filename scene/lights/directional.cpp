/// Directional lights in scene files.
#include <numbers>

#include "scene/kinds.h"
#include "scene/lights/light.h"
#include "scene/parameters.h"

namespace brandung {

Light make_light(const DirectionalLight &light) {
    Light result{};
    result.kind = kind_number(light_kinds(), "directional");
    write_words(light, result.words);
    return result;
}

Spectrum power_of_directional(const Light &light, float extent) {
    return view_of<DirectionalLight>(light.words).irradiance * (std::numbers::pi_v<float> * extent * extent);
}

/// The file says which way the light travels, the record where it comes from.
Light read_directional(const Parameters &parameters) {
    DirectionalLight light{};
    const glm::dvec3 travels(parameters.vector("direction"));
    if (travels == glm::dvec3(0)) parameters.fail("direction", "must not be zero");
    light.direction = vec3(-glm::normalize(travels));
    light.irradiance = parameters.spectrum("irradiance");
    return make_light(light);
}

}  // namespace brandung
