/// tools/bench/judge.
#include "tools/bench/judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brandung {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

Ray ray_down(float x, float y, float t_max = infinity) { return {{x, y, 1}, t_max, {0, 0, -1}, 0}; }

GeometryPrimitive square_half(float height, bool upper) {
    const vec3 a(0, 0, height), b(1, 0, height), c(1, 1, height), d(0, 1, height);
    return upper ? GeometryPrimitive{GeometryPrimitive::Kind::triangle, a, c, d} : GeometryPrimitive{GeometryPrimitive::Kind::triangle, a, b, c};
}

/// A square of two triangles, 0 and 1, which meet in its diagonal; triangle 2 below, at t = 2, and a sphere, 3, whose top is at t = 3.
SceneGeometry square() {
    const GeometryPrimitive sphere = {GeometryPrimitive::Kind::sphere, {0.5f, 0.5f, -3}, {1, 0, 0}, {}};
    return {{square_half(0, false), square_half(0, true), square_half(-1, false), sphere}, {{0, 4}}, {}};
}

Claim hit(uint primitive, float t, uint instance = 0) { return {true, primitive, instance, t}; }
constexpr Claim miss = {false};

bool is_wrong(const SceneGeometry &geometry, const Ray &ray, const Claim &claim, bool any = false) {
    const Dispute disputes[] = {{ray, any, claim, miss}};
    return judge(geometry, disputes)[0].ours_wrong;
}

TEST(TraversalJudge, OnlyTheFirstHitIsRight) {
    const SceneGeometry scene = square();
    const Ray ray = ray_down(0.75f, 0.25f);
    EXPECT_FALSE(is_wrong(scene, ray, hit(0, 1)));
    EXPECT_FALSE(is_wrong(scene, ray, hit(0, 1 + 0x1p-23f))) << "rounded";
    EXPECT_TRUE(is_wrong(scene, ray, hit(0, 1.001f))) << "elsewhere on its line";
    EXPECT_TRUE(is_wrong(scene, ray, hit(1, 1))) << "beside it";
    EXPECT_TRUE(is_wrong(scene, ray, hit(2, 2))) << "behind another";
    EXPECT_TRUE(is_wrong(scene, ray, hit(3, 3)));
    EXPECT_TRUE(is_wrong(scene, ray, miss));
    EXPECT_TRUE(is_wrong(scene, ray, hit(0, 1, 1))) << "of an instance that is not";
}

TEST(TraversalJudge, EdgesAreAmbiguousWithinRounding) {
    const SceneGeometry scene = square();
    const Ray edge = ray_down(0.5f, 0.5f), near = ray_down(0.5f, std::nextafter(0.5f, 1.0f)), beside = ray_down(0.5f, 0.501f);
    for (const Ray &ray : {edge, near}) EXPECT_FALSE(is_wrong(scene, ray, hit(0, 1)) || is_wrong(scene, ray, hit(1, 1)));
    EXPECT_TRUE(is_wrong(scene, beside, hit(0, 1)));
    EXPECT_FALSE(is_wrong(scene, beside, hit(1, 1)));
}

TEST(TraversalJudge, HitsAtTheSamePlaceAreAmbiguous) {
    SceneGeometry scene = square();
    scene.primitives[2] = square_half(0, false);
    EXPECT_FALSE(is_wrong(scene, ray_down(0.75f, 0.25f), hit(0, 1)) || is_wrong(scene, ray_down(0.75f, 0.25f), hit(2, 1)));
}

TEST(TraversalJudge, RaysEndAtTheirT) {
    const SceneGeometry scene = square();
    EXPECT_FALSE(is_wrong(scene, ray_down(0.75f, 0.25f, 0.99f), miss));
    EXPECT_TRUE(is_wrong(scene, ray_down(0.75f, 0.25f, 0.99f), hit(0, 1)));
    EXPECT_FALSE(is_wrong(scene, ray_down(0.75f, 0.25f, 1), miss)) << "just there";
}

TEST(TraversalJudge, AnyHitIsEnoughWhereOnlyThatIsAsked) {
    const SceneGeometry scene = square();
    EXPECT_FALSE(is_wrong(scene, ray_down(0.75f, 0.25f), {true}, true));
    EXPECT_TRUE(is_wrong(scene, ray_down(0.75f, 0.25f), miss, true));
    EXPECT_TRUE(is_wrong(scene, ray_down(2, 0), {true}, true));
    EXPECT_FALSE(is_wrong(scene, ray_down(2, 0), miss, true));
}

TEST(TraversalJudge, SpheresHaveTwoSides) {
    const SceneGeometry outside = {{{GeometryPrimitive::Kind::sphere, {0, 0, 0}, {0.5f, 0, 0}, {}}}, {{0, 1}}, {}};
    SceneGeometry inside = outside;
    inside.primitives[0].b.x = -0.5f;
    EXPECT_FALSE(is_wrong(outside, ray_down(0, 0), hit(0, 0.5f)));
    EXPECT_TRUE(is_wrong(outside, ray_down(0, 0), hit(0, 1.5f)));
    EXPECT_FALSE(is_wrong(inside, ray_down(0, 0), hit(0, 1.5f)));
    EXPECT_TRUE(is_wrong(inside, ray_down(0, 0), hit(0, 0.5f)));
    EXPECT_FALSE(is_wrong(outside, ray_down(0.5f, 0), miss)) << "a tangent";
    EXPECT_TRUE(is_wrong(outside, ray_down(0.49f, 0), miss));
}

/// One step along x; the world is empty.
TEST(TraversalJudge, InstancesAreWhereTheyArePlaced) {
    const Transform identity = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
    Transform there = identity, back = identity;
    there.origin.x = 1, back.origin.x = -1;
    const SceneGeometry scene = {
        {square_half(0, false)}, {{0, 0}, {0, 1}}, {{identity, identity, 0, NO_MATERIAL, {}}, {there, back, 0, NO_MATERIAL, {}}}};
    EXPECT_FALSE(is_wrong(scene, ray_down(1.75f, 0.25f), hit(0, 1, 1)));
    EXPECT_TRUE(is_wrong(scene, ray_down(1.75f, 0.25f), hit(0, 1, 0)));
    EXPECT_TRUE(is_wrong(scene, ray_down(1.75f, 0.25f), miss));
    EXPECT_FALSE(is_wrong(scene, ray_down(0.75f, 0.25f), miss));
}

}  // namespace
}  // namespace brandung
