#include "kernels/primitives/frustum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

#include "tests/scene/primitives/read_shape.h"

namespace brandung {
namespace {

FrustumBlock block_of(const Shape &shape, uint lane) {
    FrustumBlock block{};
    shape.write_lane(0, lane, reinterpret_cast<std::byte *>(&block));
    return block;
}

TEST(FrustumShape, ListsNameIt) {
    const auto frustum = make_frustum(3, {0, 0, 0}, 2, {0, 0, 4}, 1);
    EXPECT_EQ(&frustum->kind(), primitive_kinds()[3]);
    EXPECT_STREQ(frustum->kind().name, "frustum");
    EXPECT_STREQ(frustum->kind().record, "Frustum");
    EXPECT_EQ(frustum->kind().block_bytes, sizeof(FrustumBlock));
    EXPECT_EQ(frustum->material, 3u);
}

TEST(FrustumShape, WritesItsLaneAndShadingWords) {
    const auto frustum = make_frustum(0, {1, 2, 0}, 2, {1, 2, 4}, 1);
    const FrustumBlock block = block_of(*frustum, 6);
    EXPECT_EQ(vec3(block.center[0][6], block.center[1][6], block.center[2][6]), vec3(1, 2, 2));
    EXPECT_EQ(vec3(block.axis[0][6], block.axis[1][6], block.axis[2][6]), vec3(0, 0, 1));
    EXPECT_EQ(block.half_length[6], 2);
    EXPECT_EQ(block.radius[6], 1.5f);
    EXPECT_EQ(block.slope[6], -0.25f);
    EXPECT_EQ(block.side[6], 1);
    EXPECT_EQ(block.side[5], 0);

    ShadingRecord record{};
    SharedTables tables;
    frustum->write_shading(0, record.words, tables);
    FrustumShading shading;
    std::memcpy(&shading, record.words, sizeof shading);
    EXPECT_EQ(shading.center, vec3(1, 2, 2));
    EXPECT_EQ(shading.axis, vec3(0, 0, 1));
    EXPECT_EQ(shading.radius, 1.5f);
    EXPECT_EQ(shading.slope, -0.25f);
}

TEST(FrustumShape, NegativeRadiiShowTheInside) {
    const FrustumBlock block = block_of(*make_frustum(0, {0, 0, 0}, -2, {0, 0, 4}, -1), 0);
    EXPECT_EQ(block.side[0], -1);
    EXPECT_EQ(block.radius[0], 1.5f);
    EXPECT_EQ(block.slope[0], -0.25f);
    EXPECT_EQ(block_of(*make_frustum(0, {0, 0, 0}, -2, {0, 0, 4}, 0), 0).side[0], -1);
}

TEST(FrustumShape, BoundsAreTight) {
    // A cone along x, with its tip at x = 5: a disc of radius 1 at x = 1.
    const Bounds bounds = make_frustum(0, {1, 2, 3}, 1, {5, 2, 3}, 0)->bounds(0);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(bounds.low[axis], (vec3(1, 1, 2)[axis]), 1e-5);
        EXPECT_NEAR(bounds.high[axis], (vec3(5, 3, 4)[axis]), 1e-5);
    }
    // A cylinder along the diagonal of x and y: its circles reach sqrt(1/2) in x and y.
    const Bounds tilted = make_frustum(0, {0, 0, 0}, 1, {4, 4, 0}, 1)->bounds(0);
    EXPECT_NEAR(tilted.low.x, -std::sqrt(0.5), 1e-5);
    EXPECT_NEAR(tilted.high.y, 4 + std::sqrt(0.5), 1e-5);
    EXPECT_NEAR(tilted.high.z, 1, 1e-5);
    // A flat cone whose wide end reaches beyond its narrow one in the axis' direction too.
    const Bounds flat = make_frustum(0, {0, 0, 0}, 10, {0.1f, 0.1f, 0}, 1)->bounds(0);
    EXPECT_NEAR(flat.high.x, 10 * std::sqrt(0.5), 1e-4);
    EXPECT_NEAR(flat.low.x, -10 * std::sqrt(0.5), 1e-4);
}

/// Random points on the surface that a lane describes, in double.
void expect_inside(const FrustumBlock &block, const Bounds &bounds, std::mt19937 &random) {
    const glm::dvec3 center(block.center[0][0], block.center[1][0], block.center[2][0]);
    const glm::dvec3 axis(block.axis[0][0], block.axis[1][0], block.axis[2][0]);
    const glm::dvec3 other = std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(axis, other)), v = glm::normalize(glm::cross(axis, u));
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 200; ++i) {
        const double z = (i % 2 ? unit(random) : i % 4 - 1) * block.half_length[0], angle = std::numbers::pi * unit(random);
        const double radius = block.radius[0] + block.slope[0] * z;
        const glm::dvec3 p = center + z * axis + radius * (std::cos(angle) * u + std::sin(angle) * v);
        for (int k = 0; k < 3; ++k) {
            EXPECT_LE(double(bounds.low[k]), p[k]);
            EXPECT_GE(double(bounds.high[k]), p[k]);
        }
    }
}

TEST(FrustumShape, BoundsContainTheSurfaceAndAreThoseOfTheBlock) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(-3, 3), radius(0, 2);
    for (int round = 0; round < 2000; ++round) {
        vec3 base(any(random), any(random), any(random)), apex(any(random), any(random), any(random));
        if (round % 5 == 1) apex = base + vec3(0, 0, 1e-3f);                // a ring
        if (round % 5 == 2) apex.x = base.x, apex.y = base.y + 1e-4f;       // axis nearly along z
        if (round % 5 == 3) base *= 1000.0f, apex = base + vec3(1, 2, -1);  // far away
        const auto frustum = make_frustum(0, base, radius(random), apex, round % 3 == 0 ? 0 : radius(random));
        const FrustumBlock block = block_of(*frustum, 0);
        const Bounds bounds = frustum->bounds(0);
        EXPECT_EQ(bounds.low, vec3(block.low[0][0], block.low[1][0], block.low[2][0]));
        EXPECT_EQ(bounds.high, vec3(block.high[0][0], block.high[1][0], block.high[2][0]));
        expect_inside(block, bounds, random);
    }
}

TEST(FrustumShape, WithoutHeightOrRadiusIsAWarning) {
    EXPECT_EQ(make_frustum(0, {1, 2, 3}, 1, {1, 2, 3}, 2), nullptr);
    EXPECT_EQ(make_frustum(0, {1, 2, 3}, 0, {1, 2, 4}, 0), nullptr);
    EXPECT_EQ(make_frustum(0, {0, 0, 0}, 1, {0, 0, 1e-30f}, 2), nullptr);
    const Scene scene = read_shape(R"({"type": "cylinder", "base": [0, 0, 0], "apex": [0, 0, 0], "radius": 1})");
    EXPECT_TRUE(scene.shapes.empty());
    EXPECT_EQ(scene.warnings.at("cone or cylinder without height or radius: left out"), 1u);
}

TEST(FrustumShape, SceneFilesGiveConesAndCylinders) {
    const Scene cone = read_shape(R"({"type": "frustum", "base": [0, 0, 0], "base_radius": 1, "apex": [0, 0, 2], "apex_radius": 0})");
    EXPECT_EQ(block_of(*cone.shapes.at(0), 0).slope[0], -0.5f);
    EXPECT_EQ(cone.shapes[0]->material, 7u);
    const Scene cylinder = read_shape(R"({"type": "cylinder", "base": [0, 0, 0], "apex": [0, 0, 2], "radius": 0.5})");
    EXPECT_EQ(block_of(*cylinder.shapes.at(0), 0).slope[0], 0);
    EXPECT_EQ(block_of(*cylinder.shapes.at(0), 0).radius[0], 0.5f);
    EXPECT_NE(error_of_shape(R"({"type": "cylinder", "base": [0, 0, 0], "apex": [0, 0, 2], "radius": -1})"), "");
    EXPECT_NE(error_of_shape(R"({"type": "frustum", "base": [0, 0, 0], "base_radius": -1, "apex": [0, 0, 2], "apex_radius": -1})"), "");
    EXPECT_NE(error_of_shape(R"({"type": "frustum", "base": [0, 0, 0], "base_radius": 1, "apex": [0, 0, 2]})"), "");
}

}  // namespace
}  // namespace brandung
