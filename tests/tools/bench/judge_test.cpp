/// tools/bench/judge.
#include "tools/bench/judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

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
    return Judge(geometry).judge(disputes)[0].ours_wrong;
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

/// However exactly it goes through an edge or a vertex.
TEST(TraversalJudge, NoRayPassesBetweenTriangles) {
    const SceneGeometry scene = square();
    for (const float x : {0.5f, std::nextafter(0.5f, 0.0f), std::nextafter(0.5f, 1.0f)}) {
        EXPECT_TRUE(is_wrong(scene, ray_down(x, 0.5f), miss));
        EXPECT_TRUE(is_wrong(scene, ray_down(x, 0.5f), miss, true));
        EXPECT_TRUE(is_wrong(scene, ray_down(x, 0.5f), hit(3, 3))) << "below the edge";
    }
}

/// Six triangles around a vertex, one of which may be missing; vertices are at heights of their own.
SceneGeometry fan(bool whole) {
    SceneGeometry scene = {{}, {{0, whole ? 6u : 5u}}, {}};
    const auto corner = [](int i) { return vec3(std::cos(1.047f * float(i % 6)), std::sin(1.047f * float(i % 6)), 0.1f * float(i % 6)); };
    for (int i = 0; i < (whole ? 6 : 5); ++i) {
        const vec3 a = corner(i), b = corner(i + 1), middle(0, 0, 0.3f);
        scene.primitives.push_back({GeometryPrimitive::Kind::triangle, i % 2 ? a : b, i % 2 ? b : a, middle});  // either way round
    }
    return scene;
}

TEST(TraversalJudge, NoRayPassesThroughAVertexThatTrianglesSurround) {
    EXPECT_TRUE(is_wrong(fan(true), ray_down(0, 0), miss));
    EXPECT_TRUE(is_wrong(fan(true), ray_down(1e-8f, -1e-8f), miss));
    EXPECT_FALSE(is_wrong(fan(true), ray_down(0, 0), hit(2, 0.7f)));
    EXPECT_FALSE(is_wrong(fan(false), ray_down(0, 0), miss)) << "a gap";
}

/// The triangles are on the same side of the edge that they share, as where a surface turns away; or beside one another, but a hair apart.
TEST(TraversalJudge, RaysMayPassWhereTrianglesEndOrDoNotTouch) {
    SceneGeometry scene = square();
    const vec3 a(0, 0, 0), c(1, 1, 0);
    scene.spaces = {{0, 2}};
    scene.primitives[1] = {GeometryPrimitive::Kind::triangle, a, c, {1, 0.1f, -0.5f}};
    EXPECT_FALSE(is_wrong(scene, ray_down(0.5f, 0.5f), miss));
    EXPECT_TRUE(is_wrong(scene, ray_down(0.5f, 0.499f), miss));
    scene.primitives[1] = {GeometryPrimitive::Kind::triangle, a, {1, std::nextafter(1.0f, 2.0f), 0}, {0, 1, 0}};
    EXPECT_FALSE(is_wrong(scene, ray_down(0.5f, 0.5f), miss)) << "vertices that differ";
}

/// A triangle of a hundredth at a distance of a hundred, which the ray meets at a cosine of a tenth, with one behind it, as in a terrain of millions.
TEST(TraversalJudge, SmallTrianglesFarAwayMayNotBeMissed) {
    const vec3 place(57.3f, -61.7f, 54.1f), along = glm::normalize(place), across = glm::normalize(glm::cross(along, vec3(0, 1, 0)));
    const vec3 up = glm::cross(across, along), slant = 0.1f * up + std::sqrt(0.99f) * along;
    const auto triangle = [&](vec3 at) {
        return GeometryPrimitive{GeometryPrimitive::Kind::triangle, at, at + 0.01f * across, at + 0.005f * across + 0.01f * slant};
    };
    const SceneGeometry scene = {{triangle(place), triangle(place + 0.1f * along)}, {{0, 2}}, {}};
    const auto middle = [&](uint i) { return (scene.primitives[i].a + scene.primitives[i].b + scene.primitives[i].c) / 3.0f; };
    const Ray ray = {{0, 0, 0}, infinity, glm::normalize(middle(0)), 0};
    const float t = glm::length(middle(0));
    EXPECT_TRUE(is_wrong(scene, ray, miss));
    EXPECT_TRUE(is_wrong(scene, ray, hit(1, glm::length(middle(1))))) << "behind it";
    EXPECT_FALSE(is_wrong(scene, ray, hit(0, t)));
    EXPECT_FALSE(is_wrong(scene, ray, hit(0, std::nextafter(t, 0.0f))));
    EXPECT_TRUE(is_wrong(scene, ray, hit(0, t * (1 - 0x1p-13f))));
    EXPECT_TRUE(is_wrong({scene.primitives, {{1, 2}}, {}}, {ray.origin, infinity, glm::normalize(place - 0.002f * up), 0}, hit(1, t)));
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
    EXPECT_TRUE(is_wrong(outside, ray_down(0.49999f, 0), miss));
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

/// Small triangles and spheres, and rays of which many pass some of them closely.
TEST(PrimitiveTree, LeavesOutNothingThatARayMayMeetFirst) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(-1, 1);
    const auto point = [&](float size) { return size * vec3(unit(random), unit(random), unit(random)); };
    SceneGeometry scene = {{}, {{0, 3000}}, {}};
    for (uint i = 0; i < 3000; ++i) {
        const vec3 a = point(10);
        const bool is_sphere = i % 5 == 0;
        scene.primitives.push_back({is_sphere ? GeometryPrimitive::Kind::sphere : GeometryPrimitive::Kind::triangle, a,
                                    is_sphere ? vec3(0.3f * unit(random), 0, 0) : a + point(0.5f), a + point(0.5f)});
    }
    const PrimitiveTree tree(scene, scene.spaces[0]);
    std::size_t met = 0;
    for (int i = 0; i < 2000; ++i) {
        const vec3 origin = point(10), at = scene.primitives[static_cast<uint>(i)].b;
        const RayInSpace ray = ray_in_world({origin, i % 3 == 0 ? 0.5f : infinity, i % 2 ? at - origin : vec3(0, 0, 1), 0});
        std::vector<Crossing> all, found;
        for (uint k = 0; k < 3000; ++k) add_crossings(all, ray, scene.primitives[k], k, 0);
        double end = std::numeric_limits<double>::infinity(), first_certain = end;
        tree.add_crossings_of(found, ray, 0, end);
        for (const Crossing &crossing : all)
            if (crossing.certain) first_certain = std::min(first_certain, crossing.last);
        EXPECT_EQ(end, first_certain) << i;
        std::erase_if(all, [&](const Crossing &c) { return c.first > end; });
        std::erase_if(found, [&](const Crossing &c) { return c.first > end; });
        const auto number_and_t = [](const Crossing &c) { return std::pair(c.primitive, c.t); };
        std::ranges::sort(found, {}, number_and_t), std::ranges::sort(all, {}, number_and_t);
        EXPECT_TRUE(std::ranges::equal(all, found, {}, number_and_t, number_and_t)) << i;
        met += all.size();
    }
    EXPECT_GT(met, 500u);
}

}  // namespace
}  // namespace brandung
