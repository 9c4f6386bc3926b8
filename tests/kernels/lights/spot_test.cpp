#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kernels/lights/spot.h"
#include "scene/lights/light.h"
#include "tests/support/probe.h"

namespace brandung {
namespace {

using Real = long double;
constexpr Real radian = std::numbers::pi_v<Real> / 180;

/// Falloff of a cone around the axis (2, 3, 6) / 7 at angles from it [degrees], as the kernel has it.
std::vector<float> falloffs(double angle, double penumbra, const std::vector<Real> &from_axis) {
    static Probe probe(R"(#include "kernels/lights/spot.cl"
        kernel void probe(const global SpotLight *light, const global vec3 *directions, global float *results) {
            const uint i = get_global_id(0);
            results[i] = spot_falloff(*light, directions[i]);
        })",
                       {{"generated/time.cl", "#include \"kernels/core/no_time.cl\"\n"}});
    const glm::dvec3 axis = glm::dvec3(2, 3, 6) / 7.0, across = glm::normalize(glm::cross(axis, glm::dvec3(1, 0, 0)));
    SpotLight light{};
    light.direction = vec3(axis);
    shape_cone(light, glm::radians(angle), penumbra);
    std::vector<vec3> towards_light;
    for (const Real a : from_axis) towards_light.push_back(vec3(-axis * double(std::cos(a * radian)) - across * double(std::sin(a * radian))));
    return probe.run<float>(light, towards_light);
}

/// s² (3 - 2 s) between the cosines of the edge and of the full cone.
Real expected_falloff(Real angle, Real penumbra, Real from_axis) {
    const auto versed = [](Real a) { return 2 * std::pow(std::sin(a * radian / 2), 2.0L); };
    const Real edge = versed(angle / 2), full = versed(angle / 2 * (1 - penumbra));
    const Real s = std::clamp((edge - versed(from_axis)) / (edge - full), 0.0L, 1.0L);
    return s * s * (3 - 2 * s);
}

/// Directions have errors of 1e-7 in angle, which matter most in narrow cones: slopes are at most 1.5 / width in s, where s is nearly linear in
/// the angle, and nearly quadratic around the axis.
TEST(Spot, FalloffIsHermitesCubicOfTheCosineInConesOfAnyWidth) {
    for (const double angle : {0.1, 5.0, 60.0, 179.0, 180.0, 300.0, 360.0})
        for (const double penumbra : {0.01, 0.2, 1.0}) {
            std::vector<Real> from_axis;
            for (int i = 0; i <= 120; ++i) from_axis.push_back(std::min(Real(angle) / 2 * i / 100, 180.0L));
            const std::vector<float> values = falloffs(angle, penumbra, from_axis);
            const Real tolerance = 1e-6L + 4e-7L / (angle / 2 * penumbra * radian);
            for (std::size_t i = 0; i < values.size(); ++i)
                ASSERT_NEAR(values[i], expected_falloff(angle, penumbra, from_axis[i]), tolerance)
                    << angle << ", " << penumbra << ", " << from_axis[i];
        }
}

TEST(Spot, WithoutPenumbraTheEdgeIsHard) { EXPECT_EQ(falloffs(60, 0, {0, 29.9999L, 30.0001L, 90, 180}), (std::vector<float>{1, 1, 0, 0, 0})); }

}  // namespace
}  // namespace brandung
