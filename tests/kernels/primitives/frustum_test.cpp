/// Which crossings with a frustum count, kernels/primitives/frustum_hit.cl. How right they are is the self-test's matter.
#include "kernels/primitives/frustum.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <vector>

#include "tests/kernels/primitives/crossing_probe.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {

extern const PrimitiveKind frustum_kind;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct Frustum {
    vec3 base, apex;
    float base_radius, apex_radius;
};

std::unique_ptr<Shape> shape_of(const Frustum &f) { return make_frustum(0, f.base, f.base_radius, f.apex, f.apex_radius); }

CrossingProbe<FrustumBlock> probe_of(const std::vector<Frustum> &frusta) {
    std::vector<std::unique_ptr<Shape>> shapes;
    for (const Frustum &frustum : frusta) shapes.push_back(shape_of(frustum));
    return {frustum_kind, shapes};
}

const Frustum cone = {{0, 0, -1}, {0, 0, 1}, 1, 0};

CrossingResult crossing(const Frustum &frustum, vec3 origin, vec3 direction, float t_max = infinity) {
    return probe_of({frustum}).crossings({make_ray(origin, direction, t_max)})[0];
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

TEST(FrustumSurface, TheTipHasANormal) {
    // Rays into the tip, from outside and along the axis from inside; whatever is met has a normal of unit length.
    std::vector<std::unique_ptr<Shape>> shapes;
    std::vector<Ray> rays;
    std::vector<vec3> directions;
    Random random(1);
    for (int i = 0; i < 64; ++i) {
        shapes.push_back(shape_of(cone));
        const vec3 d = i == 0 ? vec3(0, 0, 1) : i == 1 ? vec3(0, 0, -1) : random.direction();
        rays.push_back(make_ray(vec3(0, 0, 1) - d, d));
        directions.push_back(vec3(0, 0, 1));
    }
    const CrossingProbe<FrustumBlock> probe(frustum_kind, shapes);
    std::size_t hits = 0;
    for (const SpawnResult &result : probe.spawned(rays, directions)) {
        if (!result.first.hit) continue;
        ++hits;
        EXPECT_NEAR(glm::length(result.surface.geometric), 1, 1e-6);
    }
    EXPECT_GT(hits, 0u);
}

/// t = 2^30 - 1 is rounded to 2^30, which leads to the axis, where there is no way outward.
TEST(FrustumSurface, APointIsOnTheSurfaceWhereRoundingLeadsToTheAxis) {
    std::vector<std::unique_ptr<Shape>> shapes;
    shapes.push_back(shape_of(cylinder));
    const SpawnResult result = CrossingProbe<FrustumBlock>(frustum_kind, shapes).spawned({make_ray({0x1p30f, 0, 0}, {-1, 0, 0})}, {vec3(1, 0, 0)})[0];
    ASSERT_TRUE(result.first.hit);
    EXPECT_EQ(result.first.t, 0x1p30f);
    EXPECT_NEAR(glm::length(vec2(result.surface.p)), 1, 1e-6);
    EXPECT_NEAR(glm::length(vec2(result.surface.geometric)), 1, 1e-6);
}

}  // namespace
}  // namespace brandung
