#include "kernels/primitives/disk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

#include "scene/lights/light.h"
#include "tests/scene/primitives/read_shape.h"

namespace brandung {
namespace {

DiskBlock block_of(const Shape &shape, uint lane) {
    DiskBlock block{};
    shape.write_lane(0, lane, reinterpret_cast<std::byte *>(&block));
    return block;
}

TEST(DiskShape, ListsNameIt) {
    const auto disk = make_disk(3, {0, 0, 0}, {0, 0, 4}, 1);
    EXPECT_EQ(&disk->kind(), primitive_kinds()[4]);
    EXPECT_STREQ(disk->kind().name, "disk");
    EXPECT_STREQ(disk->kind().record, "Disk");
    EXPECT_EQ(disk->kind().block_bytes, sizeof(DiskBlock));
    EXPECT_EQ(disk->material, 3u);
    EXPECT_EQ(disk->count(), 1u);
}

TEST(DiskShape, WritesItsLaneAndShadingWords) {
    const auto disk = make_disk(0, {1, 2, 3}, {0, -4, 0}, 2);
    const DiskBlock block = block_of(*disk, 6);
    EXPECT_EQ(vec3(block.center[0][6], block.center[1][6], block.center[2][6]), vec3(1, 2, 3));
    EXPECT_EQ(vec3(block.normal[0][6], block.normal[1][6], block.normal[2][6]), vec3(0, -1, 0));
    EXPECT_EQ(block.radius[6], 2);
    EXPECT_EQ(block.radius[5], 0);

    ShadingRecord record{};
    SharedTables tables;
    disk->write_shading(0, record.words, tables);
    DiskShading shading;
    std::memcpy(&shading, record.words, sizeof shading);
    EXPECT_EQ(shading.center, vec3(1, 2, 3));
    EXPECT_EQ(shading.normal, vec3(0, -1, 0));
    EXPECT_EQ(shading.radius, 2);
}

TEST(DiskShape, BoundsOfOneAcrossAnAxisAreItsSquare) {
    const Bounds bounds = make_disk(0, {1, 2, 3}, {0, 0, -1}, 0.5f)->bounds(0);
    EXPECT_EQ(bounds.low, vec3(0.5f, 1.5f, 3));
    EXPECT_EQ(bounds.high, vec3(1.5f, 2.5f, 3));
    // 2^-26 counts where it is not a float's: outwards.
    const Bounds odd = make_disk(0, {1, 1, 0}, {0, 0, 1}, 0x1p-26f)->bounds(0);
    EXPECT_EQ(odd.low.x, std::nextafter(1.0f, 0.0f));
    EXPECT_EQ(odd.high.x, std::nextafter(1.0f, 2.0f));
    const Bounds tiny = make_disk(0, {1, 1, 0}, {0, 0, 1}, 1e-30f)->bounds(0);
    EXPECT_EQ(tiny.low.x, std::nextafter(1.0f, 0.0f));
    EXPECT_EQ(tiny.high.x, std::nextafter(1.0f, 2.0f));
}

/// They hold the farthest points, which are known in extended precision, and no float between them and these.
TEST(DiskShape, BoundsAreThoseOfTheBlockAndTightToTheLastFloat) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(-3, 3), thin(-1e-6f, 1e-6f);
    for (int round = 0; round < 5000; ++round) {
        vec3 center(any(random), any(random), any(random)), normal(any(random), any(random), any(random));
        if (round % 4 == 1) normal = vec3(thin(random), 1, thin(random));
        if (round % 4 == 2) center *= 1000.0f;
        if (round % 4 == 3) normal[round % 3] = 0;
        const auto disk = make_disk(0, center, normal, std::exp2(any(random)));
        const DiskBlock block = block_of(*disk, 0);
        const Bounds bounds = disk->bounds(0);
        EXPECT_EQ(bounds.low, vec3(block.low[0][0], block.low[1][0], block.low[2][0]));
        EXPECT_EQ(bounds.high, vec3(block.high[0][0], block.high[1][0], block.high[2][0]));
        const long double n[] = {block.normal[0][0], block.normal[1][0], block.normal[2][0]}, square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
        for (int k = 0; k < 3; ++k) {
            const long double size = block.radius[0] * std::sqrt((n[(k + 1) % 3] * n[(k + 1) % 3] + n[(k + 2) % 3] * n[(k + 2) % 3]) / square);
            constexpr float infinity = std::numeric_limits<float>::infinity();
            EXPECT_LE(bounds.low[k], center[k] - size * (1 - 0x1p-60L));
            EXPECT_GE(bounds.high[k], center[k] + size * (1 - 0x1p-60L));
            EXPECT_GT(std::nextafter(bounds.low[k], infinity), center[k] - size * (1 + 0x1p-48L));
            EXPECT_LT(std::nextafter(bounds.high[k], -infinity), center[k] + size * (1 + 0x1p-48L));
        }
    }
}

TEST(DiskShape, OfRadiusZeroIsAWarning) {
    EXPECT_EQ(make_disk(0, {1, 2, 3}, {0, 0, 1}, 0), nullptr);
    const Scene scene = read_shape(R"({"type": "disk", "center": [1, 2, 3], "normal": [0, 0, 1], "radius": 0})");
    EXPECT_TRUE(scene.shapes.empty());
    EXPECT_EQ(scene.warnings.at("disk of radius 0: left out"), 1u);
}

TEST(DiskShape, SceneFilesGiveIt) {
    const Scene scene = read_shape(R"({"type": "disk", "center": [1, 2, 3], "normal": [0, 3, 4], "radius": 0.5})");
    ASSERT_EQ(scene.shapes.size(), 1u);
    EXPECT_EQ(scene.shapes[0]->material, 7u);
    EXPECT_EQ(block_of(*scene.shapes[0], 0).normal[1][0], 0.6f);
    EXPECT_EQ(block_of(*scene.shapes[0], 0).radius[0], 0.5f);
    EXPECT_NE(error_of_shape(R"({"type": "disk", "center": [1, 2, 3], "normal": [0, 0, 1], "radius": -1})"), "");
    EXPECT_NE(error_of_shape(R"({"type": "disk", "center": [1, 2, 3], "radius": 1})"), "");
    EXPECT_NE(error_of_shape(R"({"type": "disk", "normal": [0, 0, 1], "radius": 1})"), "");
    const std::string error = error_of_shape(R"({"type": "disk", "center": [1, 2, 3], "normal": [0, 0, 0], "radius": 1})");
    EXPECT_NE(error.find("normal: must not be zero"), std::string::npos) << error;
}

/// Of radiance 1, on both sides.
TEST(DiskShape, ShinesByItsArea) {
    std::vector<EmissiveFace> faces;
    const std::vector<Light> lights = make_disk(0, {1, 2, 3}, {0, 0, 1}, 2)->light(3, faces);
    ASSERT_EQ(lights.size(), 9u);
    EXPECT_TRUE(faces.empty());
    for (const Light &light : lights) {
        EXPECT_STREQ(light_kinds()[light.kind].name, "emissive_disk");
        EXPECT_NEAR(light_kinds()[light.kind].power(light, 1).x, 2 * std::numbers::pi * 4 * std::numbers::pi / 9, 1e-5);
    }
}

}  // namespace
}  // namespace brandung
