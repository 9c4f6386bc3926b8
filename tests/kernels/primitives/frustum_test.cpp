/// Crossings of kernels/primitives/frustum.cl against extended precision.
#include <gtest/gtest.h>

#include "tests/kernels/primitives/frustum_oracle.h"

namespace brandung {
namespace {

CrossingResult crossing(const Frustum &frustum, vec3 origin, vec3 direction, float t_max = infinity) {
    return probe_of({frustum}).crossings({make_ray(origin, direction, t_max)})[0];
}

struct Cases {
    std::vector<Frustum> frusta;
    std::vector<Ray> rays;
};
/// Cones, cylinders and frusta of three sizes, with rays at points on and near them, from near, far, or inside.
Cases random_cases(uint seed, int offset_bits) {
    Random random(seed);
    Cases cases;
    while (cases.rays.size() < count) {
        const float size = std::exp2(float(int(random.below(3)) - 1) * 20) * random.uniform(0.5f, 1);
        const Frustum frustum = random_frustum(random, size, offset_bits);
        const float s = random.uniform(0, 1), radius = std::abs(frustum.base_radius) + s * std::abs(frustum.apex_radius - frustum.base_radius);
        const vec3 on_axis = frustum.base + s * (frustum.apex - frustum.base),
                   target = on_axis + random.direction() * (radius * random.uniform(0, 1.2f));
        const vec3 origin =
            random.below(4) == 0 ? on_axis + random.in_cube(0.3f) * radius : target + random.direction() * (size * std::exp2(random.uniform(-3, 12)));
        vec3 towards = vec3(glm::normalize(glm::dvec3(target) - glm::dvec3(origin)));
        if (random.below(8) == 0) towards = vec3(glm::normalize(glm::dvec3(frustum.apex) - glm::dvec3(frustum.base)));
        if (!(glm::length(towards) > 0)) continue;
        const vec3 direction = random.below(4) == 0 ? towards * std::exp2(random.uniform(-8, 8)) : towards;
        const float t_max = random.below(4) == 0 ? glm::length(target - origin) / glm::length(direction) : infinity;
        cases.frusta.push_back(frustum);
        cases.rays.push_back(make_ray(origin, direction, t_max));
    }
    return cases;
}

const Frustum cylinder = {{0, 0, -1}, {0, 0, 1}, 1, 1};

TEST(Frustum, CrossingIsTheNearerOneThatIsBetweenTheEnds) {
    EXPECT_EQ(crossing(cylinder, {-3, 0, 0}, {1, 0, 0}).t, 2);
    EXPECT_EQ(crossing(cylinder, {0, 0, 0}, {1, 0, 0}).t, 1);
    EXPECT_EQ(crossing(cylinder, {-3, 0, 3.5f}, {1, 0, -1}).t, 4) << "over the rim, onto the far wall";
    EXPECT_EQ(crossing(cone, {-3, 0, 0}, {1, 0, 0}).t, 2.5f);
    EXPECT_EQ(crossing(cone, {-3, 0, 0}, {2, 0, 0}).t, 1.25f);
}

TEST(Frustum, EndsAreOpenAndTheOtherNappeIsNotThere) {
    EXPECT_FALSE(crossing(cylinder, {0.5f, 0, -3}, {0, 0, 1}).hit);
    EXPECT_FALSE(crossing(cylinder, {-3, 0, 1.001f}, {1, 0, 0}).hit);
    EXPECT_FALSE(crossing(cone, {-3, 0, 1.5f}, {1, 0, 0}).hit);
    EXPECT_EQ(crossing(cone, {0.5f, 0, -3}, {0, 0, 1}).t, 3) << "from below, parallel to the axis";
}

TEST(Frustum, NothingIsMetBehindBesideOrBeyondTheRaysEnd) {
    EXPECT_FALSE(crossing(cylinder, {3, 0, 0}, {1, 0, 0}).hit);
    EXPECT_FALSE(crossing(cylinder, {-3, 1.001f, 0}, {1, 0, 0}).hit);
    EXPECT_FALSE(crossing(cylinder, {-3, 0, 0}, {1, 0, 0}, 1.999f).hit);
    EXPECT_TRUE(crossing(cylinder, {-3, 0, 0}, {1, 0, 0}, 2).hit);
}

TEST(Frustum, OfNegativeRadiusOnlyTheInsideIsSeen) {
    const Frustum inside = {{0, 0, -1}, {0, 0, 1}, -1, -1};
    EXPECT_EQ(crossing(inside, {-3, 0, 0}, {1, 0, 0}).t, 4);
    EXPECT_EQ(crossing(inside, {0, 0, 0}, {1, 0, 0}).t, 1);
    EXPECT_FALSE(crossing(inside, {-3, 0, 0}, {1, 0, 0}, 3.5f).hit);
}

TEST(Frustum, ARayAlongTheSideOfAConeMeetsItOnlyBeyond) {
    // Parallel to the line on which it would be tangent: the quadratic's leading coefficient is 0.
    const CrossingResult result = crossing({{0, 0, -1}, {0, 0, 1}, 2, 0}, {-2, 0, 0}, {1, 0, -1});
    ASSERT_TRUE(result.hit);
    EXPECT_EQ(result.t, 0.5f);  // x = -2 + t, z = -t, radius 1 - z = 1 + t: 2 - t = 1 + t
}

TEST(Frustum, CrossingsAreWhatRoundingExplains) {
    for (const int offset_bits : {2, 10, 20}) {
        const Cases cases = random_cases(uint(offset_bits), offset_bits);
        const CrossingProbe<FrustumBlock> probe = probe_of(cases.frusta);
        const std::vector<CrossingResult> results = probe.crossings(cases.rays);
        std::size_t sure = 0, bad = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const std::vector<Root> roots = roots_of(record_of(probe.blocks(), i), cases.rays[i]);
            sure += sure_hits(roots, cases.rays[i].t_max);
            const testing::AssertionResult result = explains(roots, results[i], cases.rays[i].t_max);
            if (!result && ++bad <= 3) ADD_FAILURE() << "case " << i << " of offset 2^" << offset_bits << ": " << result.message();
        }
        EXPECT_EQ(bad, 0u) << "offset 2^" << offset_bits;
        EXPECT_GT(sure, count / 4) << "offset 2^" << offset_bits;
    }
}

TEST(Frustum, AllWidthsGiveTheSameBits) {
    Random random(2);
    std::vector<Frustum> frusta;
    std::vector<Ray> rays;
    while (rays.size() < count / 16 * 16) {
        const float size = std::exp2(random.uniform(-20, 20));
        const vec3 center = random.in_cube(16) * size;
        for (int i = 0; i < 16; ++i) {
            Frustum frustum;
            do {
                frustum = random_frustum(random, size, 0);
                frustum.base += center, frustum.apex += center;
            } while (!shape_of(frustum));
            frusta.push_back(frustum);
            const vec3 origin = center + random.in_cube(4) * size, target = center + random.in_cube(0.5f) * size;
            rays.push_back(make_ray(origin, (target - origin) * std::exp2(random.uniform(-4, 4)), random.below(4) ? infinity : 1.0f));
        }
    }
    const WidthResult result = probe_of(frusta).compare_widths(rays);
    EXPECT_GT(result.hits, count / 2);
    EXPECT_EQ(result.different_8, 0u);
    EXPECT_EQ(result.different_16, 0u);
}

}  // namespace
}  // namespace brandung
