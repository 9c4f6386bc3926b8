#include "kernels/primitives/sphere.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "scene/error.h"
#include "scene/parameters.h"
#include "scene/scene.h"
#include "tests/scene/primitives/read_shape.h"

namespace brandung {
namespace {

TEST(SphereShape, ListsNameIt) {
    const auto sphere = make_sphere(3, {1, 2, 3}, 4);
    EXPECT_EQ(&sphere->kind(), primitive_kinds()[0]);
    EXPECT_STREQ(sphere->kind().name, "sphere");
    EXPECT_STREQ(sphere->kind().record, "Sphere");
    EXPECT_EQ(sphere->kind().block_bytes, sizeof(SphereBlock));
    EXPECT_EQ(sphere->material, 3u);
    EXPECT_EQ(sphere->count(), 1u);
}

TEST(SphereShape, WritesItsLaneAndShadingWords) {
    const auto sphere = make_sphere(0, {1, 2, 3}, -4);
    SphereBlock block{};
    sphere->write_lane(0, 5, reinterpret_cast<std::byte *>(&block));
    EXPECT_EQ(vec3(block.x[5], block.y[5], block.z[5]), vec3(1, 2, 3));
    EXPECT_EQ(block.radius[5], -4);
    EXPECT_EQ(block.radius[4], 0);
    EXPECT_EQ(block.primitive[5], 0u);

    ShadingRecord record{};
    SharedTables tables;
    sphere->write_shading(0, record.words, tables);
    SphereShading shading;
    std::memcpy(&shading, record.words, sizeof shading);
    EXPECT_EQ(shading.center, vec3(1, 2, 3));
    EXPECT_EQ(shading.radius, -4);
}

TEST(SphereShape, BoundsAreCenterAndRadiusInFloat) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(-10, 10);
    for (int round = 0; round < 1000; ++round) {
        const vec3 center(any(random), any(random), any(random));
        const float radius = any(random), r = std::abs(radius);
        const Bounds bounds = make_sphere(0, center, radius)->bounds(0);
        EXPECT_EQ(bounds.low, vec3(center.x - r, center.y - r, center.z - r));
        EXPECT_EQ(bounds.high, vec3(center.x + r, center.y + r, center.z + r));
    }
}

TEST(SphereShape, RadiusZeroIsAWarning) {
    EXPECT_EQ(make_sphere(0, {1, 2, 3}, 0), nullptr);
    const Scene scene = read_shape(R"({"type": "sphere", "center": [1, 2, 3], "radius": 0})");
    EXPECT_TRUE(scene.shapes.empty());
    EXPECT_EQ(scene.warnings.at("sphere of radius 0: left out"), 1u);
}

TEST(SphereShape, SceneFilesGiveCenterAndRadius) {
    const Scene scene = read_shape(R"({"type": "sphere", "center": [1, 2, 3], "radius": 0.5})");
    ASSERT_EQ(scene.shapes.size(), 1u);
    EXPECT_EQ(scene.shapes[0]->material, 7u);
    EXPECT_EQ(scene.shapes[0]->bounds(0).low, vec3(0.5f, 1.5f, 2.5f));
    EXPECT_THROW(read_shape(R"({"type": "sphere", "center": [1, 2, 3], "radius": -1})"), SceneError);
    EXPECT_THROW(read_shape(R"({"type": "sphere", "center": [1, 2, 3]})"), SceneError);
    EXPECT_THROW(read_shape(R"({"type": "sphere", "radius": 1})"), SceneError);
}

}  // namespace
}  // namespace brandung
