/// Light from points and directions: where it comes from, how far that is, and how much it is.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "runtime/selftest/describe.h"
#include "runtime/selftest/examine.h"
#include "runtime/selftest/extended.h"
#include "runtime/selftest/input_source.h"
#include "runtime/selftest/light_kernel.h"
#include "runtime/selftest/subjects/list.h"

namespace brandung {
namespace {

constexpr std::size_t inputs_per_round = 1 << 16;

template <class View> View view_of(const Light &light) {
    View view;
    std::memcpy(&view, light.words, sizeof view);
    return view;
}

/// What is right, and by how much of it rounding may change it.
struct Expected {
    Vector way;  ///< to the light
    bool is_far;
    double irradiance;  ///< of intensity 1
    double error;       ///< absolute
};

vec3 any_place(InputSource &source) { return source.one_in(16) ? vec3(0) : source.direction() * source.power_of_two(-20, 20); }

/// Some parts of it may be 0, not all.
vec3 any_attenuation(InputSource &source) {
    const auto part = [&] { return source.one_in(3) ? 0.0f : source.power_of_two(-10, 10); };
    const vec3 attenuation(part(), part(), part());
    return attenuation == vec3(0) ? vec3(0, 0, 1) : attenuation;
}

PointLight any_point(InputSource &source) { return {any_place(source), Spectrum(1), any_attenuation(source)}; }
Light make_any_point(InputSource &source) { return make_light(any_point(source)); }

Light make_any_directional(InputSource &source) { return make_light(DirectionalLight{source.direction(), Spectrum(1)}); }

/// Cones from pencils of light to everywhere; hard and soft.
Light make_any_spot(InputSource &source) {
    const PointLight point = any_point(source);
    SpotLight light{point.position, source.direction(), Spectrum(1), point.attenuation, 0, 0};
    shape_cone(light, source.one_in(2) ? source.power_of_two(-10, 0) : source.uniform(0.01, 6.28), source.one_in(8) ? 0 : source.unit());
    return make_light(light);
}

/// The way's components are rounded, so are sums of 3 squares and roots: distances to 4 u, directions to 6 u. Attenuation is a sum of terms that
/// are not negative, each with up to 6 roundings and twice the distance's error; the quotient adds 2 u.
Expected from_point(const PointLight &light, vec3 p) {
    const Vector way = Vector(light.position) - Vector(p);
    const extended d = length(way), value = 1 / (light.attenuation.x + light.attenuation.y * d + light.attenuation.z * d * d);
    return {way, false, double(value), 24 * unit_roundoff * double(value)};
}
Expected expected_of_point(const Light &light, vec3 p) { return from_point(view_of<PointLight>(light), p); }

Expected expected_of_directional(const Light &light, vec3) { return {Vector(view_of<DirectionalLight>(light).direction), true, 1, 0}; }

/// The sum of both directions, which is as long as they are apart, is off by 8 u, and by u of itself; s by that, as half its square, and by 4 u of
/// what is subtracted, times the steepness; the cubic's slope is 3 / 2 at most. By sin²(a / 2), which is half of what the kernel calls 1 - cos a.
Expected expected_of_spot(const Light &l, vec3 p) {
    const SpotLight light = view_of<SpotLight>(l);
    Expected expected = from_point({light.position, light.intensity, light.attenuation}, p);
    const Vector axis = unit(Vector(light.direction)), towards = unit(expected.way), aside = cross(axis, towards);
    const extended cosine = -dot(axis, towards), square = dot(aside, aside), apart = cosine > 0 ? square / (1 + cosine) : 1 - cosine;
    const extended s = lesser(greater((light.edge - apart) * light.steepness, 0), 1), falloff = s * s * (3 - 2 * s);
    const extended length_of_sum = square_root(2 * apart), u = unit_roundoff;
    const extended error = light.steepness * ((length_of_sum + 8 * u) * 8 * u + 4 * u * (apart + light.edge)) + 4 * u * s;
    expected.error = double(greater(expected.error, 24 * u * expected.irradiance) * falloff + 1.5 * lesser(error, 1) * expected.irradiance);
    expected.irradiance *= double(falloff);
    return expected;
}

struct LightOfPoint {
    const char *name;
    Light (*make)(InputSource &);
    Expected (*expected)(const Light &light, vec3 p);
};
constexpr LightOfPoint kinds[] = {{"point", make_any_point, expected_of_point},
                                  {"directional", make_any_directional, expected_of_directional},
                                  {"spot", make_any_spot, expected_of_spot}};

/// Somewhere; near the light; in a spot's cone, about its edge.
vec3 any_lit_point(InputSource &source, const Light &light, bool is_spot) {
    const vec3 position = view_of<SpotLight>(light).position, away = source.direction() * source.power_of_two(-10, 30);
    if (!is_spot) return source.one_in(2) ? any_place(source) : position + away;
    const SpotLight spot = view_of<SpotLight>(light);
    const float sine = float(std::sqrt(std::max(0.0, spot.edge * (2 - double(spot.edge))))) * source.uniform(0, 1.2);
    const vec3 aside = glm::normalize(glm::cross(spot.direction, source.direction()) + vec3(1e-30f));
    return source.one_in(4) ? position + away : position + (spot.direction * (1 - spot.edge) + aside * sine) * source.power_of_two(-10, 30);
}

class LightFromPoint final : public Subject {
public:
    LightFromPoint(Device &device, const LightOfPoint &kind) : kind_(kind), kernel_(device) {}

    Findings examine(uint round) override {
        LitPoints lit;
        InputSource source(seed_of(10, round, 0));
        const bool is_spot = kind_.make == make_any_spot, is_far = kind_.make == make_any_directional;
        while (lit.lights.size() < inputs_per_round) {
            const Light light = kind_.make(source);
            const vec3 p = is_far ? any_place(source) : any_lit_point(source, light, is_spot);
            if (!is_far && p == view_of<PointLight>(light).position) continue;
            lit.lights.push_back(light), lit.points.push_back(p), lit.branches.push_back(0);
        }
        const std::vector<LightSample> samples = kernel_(lit);
        return examine_each(inputs_per_round,
                            [&](std::size_t i, Findings &findings) { look_at(lit.lights[i], lit.points[i], samples[i], findings); });
    }

private:
    void look_at(const Light &light, vec3 p, const LightSample &sample, Findings &findings) const {
        const Expected expected = kind_.expected(light, p);
        const auto describe = [&](const char *what) {
            return [&, what] {
                std::string words;
                for (const uint word : light.words) words += fmt::format(" {:a}", std::bit_cast<float>(word));
                return fmt::format("{} at {} from the light{}", what, text_of(p), words);
            };
        };
        findings.hits += expected.irradiance > 0;
        const double turned = double(length(Vector(sample.direction) - unit(expected.way))), distance = double(length(expected.way));
        findings.measure(Quantity::normal, turned, 8 * unit_roundoff, 2 * unit_roundoff, 1, describe("the direction is off"));
        if (sample.ray_direction != sample.direction) findings.blame(describe("the ray has another direction"));
        if (expected.is_far && sample.distance != INFINITY) findings.blame(describe("a distance"));
        if (!expected.is_far)
            findings.measure(Quantity::t, std::abs(sample.distance - distance), 4 * unit_roundoff * distance, ulp_of(distance), distance,
                             describe("the distance is off"));
        for (const float value : {sample.irradiance.x, sample.irradiance.y, sample.irradiance.z})
            findings.measure(Quantity::value, std::abs(value - expected.irradiance), expected.error + 0x1p-148, ulp_of(expected.irradiance),
                             expected.irradiance, describe("the irradiance is off"));
    }

    const LightOfPoint &kind_;
    LightKernel kernel_;
};

}  // namespace

void add_point_lights(std::vector<SubjectEntry> &list) {
    for (const LightOfPoint &kind : kinds)
        list.push_back({std::string("light_") + kind.name, fmt::format("lights/{}.cl, attenuation.cl", kind.name),
                        "direction: 8 roundings, t: 4; value: those of its terms", 2,
                        [&kind](Device &device) { return std::make_unique<LightFromPoint>(device, kind); }});
}

}  // namespace brandung
