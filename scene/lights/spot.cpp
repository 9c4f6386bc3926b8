/// Spot lights in scene files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/kinds.h"
#include "scene/lights/light.h"
#include "scene/parameters.h"

namespace brandung {
namespace {

/// 1 - cos a, without the cancellation at small angles.
double one_minus_cosine(double a) { return 2 * std::sin(a / 2) * std::sin(a / 2); }

vec3 read_axis(const Parameters &parameters, vec3 position) {
    const bool has_at = parameters.has("at");
    const bool has_direction = parameters.has("direction");
    if (has_at && has_direction) parameters.fail("at", "the light has both \"direction\" and \"at\", but needs only one of them");
    if (!has_at && !has_direction) parameters.fail("", "needs either \"direction\" or \"at\"");
    const vec3 way = has_at ? parameters.vector("at") : parameters.vector("direction");
    if (has_at && way == position) parameters.fail("at", "must differ from \"position\"");
    if (!has_at && way == vec3(0)) parameters.fail("direction", "must not be zero");
    return vec3(glm::normalize(has_at ? glm::dvec3(way) - glm::dvec3(position) : glm::dvec3(way)));
}

}  // namespace

/// Where rounding makes the penumbra's width 0 the edge is hard: the steepest slope that no difference of cosines makes infinite.
void shape_cone(SpotLight &light, double angle, double penumbra) {
    const double edge = one_minus_cosine(angle / 2), full = one_minus_cosine(angle / 2 * (1 - penumbra));
    light.edge = float(edge);
    light.steepness = float(1 / std::max(edge - full, 0x1p-100));
}

Light make_light(const SpotLight &light) {
    Light result{};
    result.kind = kind_number(light_kinds(), "spot");
    write_words(light, result.words);
    return result;
}

/// That of the whole cone at full intensity.
Spectrum power_of_spot(const Light &light, float extent) {
    const SpotLight view = view_of<SpotLight>(light.words);
    return view.intensity * (2 * std::numbers::pi_v<float> * view.edge / attenuation_to_square(view.attenuation, extent));
}

Light read_spot(const Parameters &parameters) {
    SpotLight light{};
    light.position = parameters.vector("position");
    light.direction = read_axis(parameters, light.position);
    light.intensity = parameters.spectrum("intensity");
    light.attenuation = read_attenuation(parameters);
    const float degrees = parameters.positive("angle", 60.0f), penumbra = parameters.not_negative("penumbra", 0.2f);
    if (degrees > 360) parameters.fail("angle", fmt::format("must be at most 360 degrees, got {:g}", degrees));
    if (penumbra > 1) parameters.fail("penumbra", fmt::format("must be at most 1, got {:g}", penumbra));
    shape_cone(light, glm::radians(double(degrees)), penumbra);
    return make_light(light);
}

}  // namespace brandung
