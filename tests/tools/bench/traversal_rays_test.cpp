/// tools/bench/terrain, scene_geometry, traversal_rays and disagreement.
#include "tools/bench/traversal_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "runtime/renderer.h"
#include "runtime/selftest/oracle.h"
#include "scene/compile.h"
#include "scene/vectors.h"
#include "tools/bench/disagreement.h"
#include "tools/bench/terrain.h"

namespace brandung {
namespace {

SceneGeometry geometry_of(const Scene &scene) { return geometry_of(scene, compile(scene)); }

/// A floor at y = 0, 20 wide, seen from above; who asks finds it by hand.
SceneGeometry floor_geometry() {
    const vec3 a(-10, 0, -10), b(30, 0, -10), c(-10, 0, 30);
    return {{{GeometryPrimitive::Kind::triangle, a, b, c}}, {{0, 1}}, {}};
}

RayAnswers find_floor(const RayQueue &queue) {
    RayAnswers answers;
    for (const Ray &ray : queue.rays) {
        const float t = -ray.origin.y / ray.direction.y;
        answers.hits.push_back({t, 0, 0, t > 0 ? 0 : NO_HIT}), answers.instances.push_back(0);
    }
    return answers;
}

std::vector<RaySet> floor_rays(const std::vector<std::string> &names, vec3 light = {0, 3, 0}) {
    const Camera camera = make_camera({.name = "", .from = {0.1f, 2, 0.2f}, .at = {0, 0, 0}, .up = {0, 0, 1}}, 64, 64);
    return make_ray_sets(names, camera, light, floor_geometry(), find_floor);
}

TEST(Terrain, HasAboutAsManyTrianglesAsAskedForAndIsFinite) {
    for (const uint wanted : {5000u, 20000u, 100000u}) {
        const SceneGeometry geometry = geometry_of(terrain(wanted));
        EXPECT_NEAR(double(geometry.primitives.size()), wanted, 0.1 * wanted);
        for (const GeometryPrimitive &triangle : geometry.primitives)
            ASSERT_TRUE(triangle.kind == GeometryPrimitive::Kind::triangle && is_finite(triangle.a) && is_finite(triangle.b) &&
                        is_finite(triangle.c));
    }
}

TEST(Terrain, IsTheSameEachTime) {
    const SceneGeometry a = geometry_of(terrain(5000)), b = geometry_of(terrain(5000));
    ASSERT_EQ(a.primitives.size(), b.primitives.size());
    EXPECT_EQ(std::memcmp(a.primitives.data(), b.primitives.data(), a.primitives.size() * sizeof(GeometryPrimitive)), 0);
}

TEST(TraversalRays, CameraRaysGoThroughPixelsInARendersOrder) {
    const std::vector<RaySet> sets = floor_rays({"camera"});
    ASSERT_EQ(sets.size(), 1u);
    ASSERT_EQ(sets[0].queue.count(), 64u * 64u);
    EXPECT_TRUE(sets[0].queue.coherent && !sets[0].queue.shadow);
    const auto &rays = sets[0].queue.rays;
    EXPECT_GT(glm::distance(rays[0].direction, rays[64].direction), glm::distance(rays[0].direction, rays[1].direction)) << "blocks of 8 x 8";
    for (const Ray &ray : rays) ASSERT_NEAR(glm::length(ray.direction), 1, 1e-6);
}

TEST(TraversalRays, BouncesLeaveTheSurfaceOnTheSideThatIsSeen) {
    const std::vector<RaySet> sets = floor_rays({"diffuse", "any"});
    ASSERT_EQ(sets.size(), 2u);
    for (const RaySet &set : sets) EXPECT_FALSE(set.queue.coherent);
    double cosines = 0;
    for (const Ray &ray : sets[0].queue.rays) {
        ASSERT_GT(ray.origin.y, 0);
        ASSERT_LT(ray.origin.y, 1e-4);
        ASSERT_GE(ray.direction.y, 0);
        ASSERT_EQ(RAY_SOURCE(ray.tag), 0u) << "the floor";
        cosines += double(ray.direction.y);
    }
    EXPECT_NEAR(cosines / double(sets[0].queue.count()), 2.0 / 3, 0.02) << "of a cosine distribution";
    ASSERT_EQ(sets[1].queue.count(), sets[0].queue.count());
    EXPECT_TRUE(sets[1].queue.shadow);
    EXPECT_EQ(sets[1].queue.rays[5].direction, sets[0].queue.rays[5].direction);
}

TEST(TraversalRays, ShadowRaysEndAtTheLightAndOnlyWhereItShines) {
    const std::vector<RaySet> sets = floor_rays({"shadow"});
    EXPECT_TRUE(sets[0].queue.coherent);
    EXPECT_GT(sets[0].queue.count(), 0u);
    for (const Ray &ray : sets[0].queue.rays) ASSERT_NEAR(glm::distance(ray.origin + ray.t_max * ray.direction, vec3(0, 3, 0)), 0, 1e-5);
    EXPECT_EQ(floor_rays({"shadow"}, {0, -3, 0})[0].queue.count(), 0u);
}

/// A primitive of some kind about (3, 4, 5), seen from the front by rays that meet it where a high precision has it.
class RaysFromEveryKind : public testing::TestWithParam<const PrimitiveOracle *> {
protected:
    /// The closest thing that is surely there.
    RayAnswers find(const RayQueue &queue) const {
        RayAnswers answers;
        for (const Ray &ray : queue.rays) {
            Hit hit{0, 0, 0, NO_HIT};
            for (const Root &root : oracle.roots(lane, ray))
                if (root.sure && root.t > 0 && (hit.primitive == NO_HIT || root.t < hit.t)) hit = {float(root.t), 0, 0, 0};
            answers.hits.push_back(hit), answers.instances.push_back(0);
        }
        return answers;
    }
    void make(InputSource &source) {
        scene = Scene{};
        scene.materials.push_back({"", {}});
        while (scene.shapes.empty())
            if (auto shape = oracle.make(source, {3, 4, 5}, 1)) scene.shapes.push_back(std::move(shape));
        scene.shapes[0]->write_lane(0, 0, block.data());
    }

    const PrimitiveOracle &oracle = *GetParam();
    Scene scene;
    std::vector<std::byte> block = std::vector<std::byte>(oracle.kind().block_bytes);
    const Lane lane{block.data(), 0};
};

TEST_P(RaysFromEveryKind, BeginOnIt) {
    InputSource source(1);
    std::size_t count = 0;
    for (int i = 0; i < 8; ++i) {
        make(source);
        const Camera camera = make_camera({.name = "", .from = {3.1f, 4.2f, 12}, .at = {3, 4, 5}}, 64, 64);
        const SceneGeometry geometry = geometry_of(scene);
        for (const RaySet &set :
             make_ray_sets({"diffuse", "shadow"}, camera, {3, 4, 15}, geometry, [&](const RayQueue &queue) { return find(queue); })) {
            count += set.queue.count();
            for (const Ray &ray : set.queue.rays) {
                ASSERT_LT(absolute(oracle.distance(lane, ray.origin)), 5e-5);
                ASSERT_LT(oracle.beyond_ends(lane, ray.origin), 5e-5);
                ASSERT_LT(glm::distance(ray.origin, vec3(3, 4, 5)), 4);
                ASSERT_GT(dot(oracle.normal_at(lane, ray.origin).n, Vector(ray.direction)) * oracle.distance(lane, ray.origin), 0)
                    << "it leaves the side";
            }
        }
    }
    EXPECT_GT(count, 200u);
}

INSTANTIATE_TEST_SUITE_P(TraversalRays, RaysFromEveryKind, testing::ValuesIn(primitive_oracles()),
                         [](const auto &info) { return std::string(info.param->kind().name); });

TEST(TraversalRays, AreTheSameEachTime) {
    const auto a = floor_rays({"diffuse"}), b = floor_rays({"diffuse"});
    EXPECT_EQ(std::memcmp(a[0].queue.rays.data(), b[0].queue.rays.data(), a[0].queue.count() * sizeof(Ray)), 0);
}

std::optional<Disagreement> compare_on_floor(const RayAnswers &ours, const RayAnswers &theirs, bool goes_on = true) {
    const SceneGeometry geometry = floor_geometry();
    return compare_answers(Judge(geometry), floor_rays({"camera"})[0].queue, ours, theirs, [&] { return goes_on; });
}

/// One of 4096 hits is made a miss, and one is moved.
TEST(Disagreement, CountsWhoIsWrong) {
    const RayAnswers right = find_floor(floor_rays({"camera"})[0].queue);
    RayAnswers wrong = right;
    wrong.hits[17].primitive = NO_HIT, wrong.hits[99].t *= 1.001f;
    const Disagreement ours = compare_on_floor(wrong, right).value(), theirs = compare_on_floor(right, wrong).value();
    EXPECT_EQ(ours.mismatches, 2u);
    EXPECT_EQ(ours.judged, 2u + 4096 / 16);
    EXPECT_EQ(ours.ours_wrong, 2u);
    EXPECT_EQ(ours.theirs_wrong, 0u);
    EXPECT_EQ(theirs.theirs_wrong, 2u);
    EXPECT_EQ(theirs.ambiguous, 0u);
    EXPECT_EQ(compare_on_floor(right, right)->mismatches, 0u);
}

TEST(Disagreement, CountsWhatBothSayWrongly) {
    RayAnswers wrong = find_floor(floor_rays({"camera"})[0].queue);
    wrong.hits[32].primitive = NO_HIT;
    const Disagreement found = compare_on_floor(wrong, wrong).value();
    EXPECT_EQ(found.mismatches, 0u);
    EXPECT_EQ(found.ours_wrong, 1u);
    EXPECT_EQ(found.theirs_wrong, 1u);
}

TEST(Disagreement, EndsWhenItIsTold) {
    const RayAnswers right = find_floor(floor_rays({"camera"})[0].queue);
    EXPECT_FALSE(compare_on_floor(right, right, false).has_value());
}

}  // namespace
}  // namespace brandung
