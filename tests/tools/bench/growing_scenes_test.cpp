#include "tools/bench/growing_scenes.h"

#include <gtest/gtest.h>

#include <numbers>

namespace brandung {
namespace {

double volume(const Scene &scene) {
    double sum = 0;
    for (const auto &shape : scene.shapes) {
        const double radius = 0.5 * double(shape->bounds(0).high.x - shape->bounds(0).low.x);
        sum += 4 * std::numbers::pi / 3 * radius * radius * radius;
    }
    return sum;
}

TEST(GrowingScenes, SpheresHaveTheSamePartOfTheCubeHoweverMany) {
    for (const uint objects : {100u, 3000u}) {
        const Scene scene = growing_scene("spheres", objects);
        EXPECT_EQ(scene.shapes.size(), objects);
        EXPECT_NEAR(volume(scene), 0.02, 1e-5);
    }
}

/// Half of the volume is that of the spheres outside; those in the cluster have a millionth of that.
TEST(GrowingScenes, HalfOfAClumpedSceneIsAHundredthAsWide) {
    const Scene scene = growing_scene("clumped", 1001);
    EXPECT_EQ(scene.shapes.size(), 1001u);
    EXPECT_NEAR(volume(scene), 0.02 * (501 + 500e-6) / 1001, 1e-5);
    for (std::size_t i = 0; i < 500; ++i) {
        const vec3 centre = 0.5f * (scene.shapes[i]->bounds(0).low + scene.shapes[i]->bounds(0).high);
        for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(centre[axis], 0.5, 0.0051);
    }
}

/// An equilateral triangle's height is 3/4 of the diameter of the circle about it, so that no box is longer than its edge, and the longest side of
/// none is shorter than half of that.
TEST(GrowingScenes, TrianglesAreOneMesh) {
    const Scene scene = growing_scene("triangles", 1000);
    ASSERT_EQ(scene.shapes.size(), 1u);
    ASSERT_EQ(scene.shapes[0]->count(), 1000u);
    for (std::size_t i = 0; i < 1000; ++i) {
        const vec3 size = scene.shapes[0]->bounds(i).high - scene.shapes[0]->bounds(i).low;
        const float longest = std::max({size.x, size.y, size.z});
        EXPECT_LT(longest, 0.0501);
        EXPECT_GT(longest, 0.025);
    }
}

TEST(GrowingScenes, RaysBeginInTheCubeAndShadowRaysEndThereToo) {
    const std::vector<RayQueue> queues = rays_in_cube(1000);
    ASSERT_EQ(queues.size(), 2u);
    EXPECT_EQ(queues[0].shadow, false);
    EXPECT_EQ(queues[1].shadow, true);
    for (const RayQueue &queue : queues) {
        ASSERT_EQ(queue.count(), 1000u);
        for (const Ray &ray : queue.rays) EXPECT_NEAR(glm::length(ray.direction), 1, 1e-6);
    }
    for (const Ray &ray : queues[1].rays)
        for (const vec3 end : {ray.origin, ray.origin + ray.t_max * ray.direction})
            for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(end[axis], 0.5, 0.500001);
}

}  // namespace
}  // namespace brandung
