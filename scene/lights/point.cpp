/// Point lights in scene files.
#include <numbers>

#include "scene/kinds.h"
#include "scene/lights/light.h"
#include "scene/parameters.h"

namespace brandung {

Light make_light(const PointLight &light) {
    Light result{};
    result.kind = kind_number(light_kinds(), "point");
    write_words(light, result.words);
    return result;
}

vec3 read_attenuation(const Parameters &parameters) {
    const vec3 attenuation = parameters.vector("attenuation", vec3(0, 0, 1));
    if (glm::any(glm::lessThan(attenuation, vec3(0)))) parameters.fail("attenuation", "must not have negative parts");
    if (attenuation == vec3(0)) parameters.fail("attenuation", "must not be all zero, the intensity is divided by it");
    return attenuation;
}

float attenuation_to_square(vec3 attenuation, float distance) { return (attenuation.x / distance + attenuation.y) / distance + attenuation.z; }

Spectrum power_of_point(const Light &light, float extent) {
    const PointLight view = view_of<PointLight>(light.words);
    return view.intensity * (4 * std::numbers::pi_v<float> / attenuation_to_square(view.attenuation, extent));
}

Light read_point(const Parameters &parameters) {
    PointLight light{};
    light.position = parameters.vector("position");
    light.intensity = parameters.spectrum("intensity");
    light.attenuation = read_attenuation(parameters);
    return make_light(light);
}

}  // namespace brandung
