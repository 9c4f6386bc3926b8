/// kernels/core/terminator.cl.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/probe.h"

namespace brandung {
namespace {

/// Of directions in the plane of both normals, the shading normal being so far from the geometric one towards the light, at these angles from the
/// latter.
std::vector<float> factors(double between, const std::vector<double> &angles) {
    std::vector<vec3> normals, directions;
    for (const double angle : angles) {
        normals.emplace_back(std::sin(between), 0, std::cos(between));
        directions.emplace_back(std::sin(angle), 0, std::cos(angle));
    }
    return Probe(R"(#include "kernels/core/terminator.cl"
        kernel void probe(const global vec3 *normals, const global vec3 *directions, global float *factors) {
            const uint i = get_global_id(0);
            factors[i] = terminator_factor(normals[i], make3(0.0f, 0.0f, 1.0f), directions[i]);
        })")
        .run<float>(normals, directions);
}

constexpr double quarter = M_PI / 2;

std::vector<double> angles_up_to(double end) {
    std::vector<double> angles;
    for (int i = 0; i <= 1000; ++i) angles.push_back(end * i / 1000);
    return angles;
}

TEST(Terminator, NothingIsLostWhereTheNormalsAreTheSame) {
    for (const float factor : factors(0, angles_up_to(quarter - 1e-3))) EXPECT_NEAR(factor, 1, 1e-4);
}

TEST(Terminator, TheFactorFallsSmoothlyTo0AtTheSurfacesOwnHorizon) {
    for (const double between : {0.05, 0.2, 0.6}) {
        const std::vector<float> all = factors(between, angles_up_to(quarter));
        EXPECT_EQ(all.front(), 1) << "far above";
        EXPECT_NEAR(all.back(), 0, 1e-6);
        for (std::size_t i = 1; i < all.size(); ++i) {
            ASSERT_LE(all[i], all[i - 1] + 1e-6f) << between << ' ' << i;
            ASSERT_LT(all[i - 1] - all[i], 0.1) << between << ' ' << i;
        }
    }
}

TEST(Terminator, NothingComesFromBelowEitherHorizon) {
    for (const float factor : factors(0.3, {quarter + 0.01, quarter + 0.2, -quarter - 0.01, -quarter + 0.29})) EXPECT_EQ(factor, 0);
}

}  // namespace
}  // namespace brandung
