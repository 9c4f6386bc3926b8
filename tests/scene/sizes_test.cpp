/// Scenes that a device cannot hold are refused before anything is built.
#include "scene/compilation/sizes.h"

#include <gtest/gtest.h>

#include <utility>

#include "kernels/core/items.h"
#include "kernels/primitives/sphere.h"
#include "scene/accelerators/accelerator.h"
#include "scene/error.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

Scene soup(uint of_each) {
    Scene scene = empty_scene();
    scene.file = "soup.json";
    add_soup(scene, 0, {.of_each = of_each});
    return scene;
}

template <class Attempt> std::string error_of(const Attempt &attempt) {
    try {
        attempt();
    } catch (const SceneError &error) {
        return error.what();
    }
    return "";
}

TEST(Sizes, CountNoMoreThanTheArenaHolds) {
    for (const uint of_each : {1u, 8u, 100u, 3'000u}) {
        const Scene scene = soup(of_each);
        const LeastSizes sizes = least_sizes(scene);
        const CompiledScene compiled = compile(scene);
        EXPECT_EQ(sizes.primitives, compiled.primitive_count);
        EXPECT_LE(sizes.blocks, compiled.block_bytes);
        EXPECT_GT(sizes.blocks, compiled.block_bytes / 2);
        EXPECT_EQ(sizes.shading, compiled.shading_bytes);
        EXPECT_LE(sizes.all(), compiled.arena.size());
    }
}

TEST(Sizes, GroupsCountOnceAndOnlyIfTheyAreUsed) {
    Scene scene = soup(0);
    Scene group = soup(20);
    const LeastSizes alone = least_sizes(group);
    add_group(scene, "group", std::move(group.shapes));
    EXPECT_EQ(least_sizes(scene).all(), 0u);
    for (int i = 0; i < 2; ++i) ASSERT_FALSE(add_instance(scene, 0, AffineMap()));
    EXPECT_EQ(least_sizes(scene).all(), alone.all());
}

TEST(Sizes, WhatNoAllocationHoldsIsRefusedBeforeItIsBuiltIfItsPrimitivesAlreadyAreTooMuch) {
    Scene scene = empty_scene();
    scene.file = "balls.nff";
    for (uint i = 0; i < 9; ++i) add_sphere(scene, 0, vec3(float(i)), 1);
    const std::size_t needed = 2 * sizeof(SphereBlock) + 9 * sizeof(ShadingRecord);
    bool builds = false;
    const auto compile_within = [&](std::size_t bytes) {
        compile(scene, {.watch = [&](const AcceleratorKind &, double) { builds = true; }, .limit = {bytes, "slide rule"}});
    };
    EXPECT_EQ(error_of([&] { compile_within(needed - 1); }),
              "balls.nff: 9 primitives take at least 0.0 MiB (0.0 MiB of blocks, 0.0 MiB of shading records); one allocation of 'slide rule' takes "
              "0.0 MiB at most");
    EXPECT_FALSE(builds);
    const std::size_t all = compile(scene).arena.size();
    ASSERT_GT(all, needed);
    for (const std::size_t too_little : {needed, all - 1})
        EXPECT_EQ(error_of([&] { compile_within(too_little); }),
                  "balls.nff: 9 primitives and 0 instances take 0.0 MiB (0.0 MiB of blocks, 0.0 MiB of nodes, 0.0 MiB of shading records, 0.0 MiB of "
                  "others); one allocation of 'slide rule' takes 0.0 MiB at most");
    EXPECT_TRUE(builds);
    EXPECT_EQ(error_of([&] { compile_within(all); }), "");
}

/// Stands for more primitives than a test can make.
class Crowd : public Shape {
public:
    explicit Crowd(std::size_t count) : Shape(0), count_(count) {}
    const PrimitiveKind &kind() const override { return *primitive_kinds().front(); }
    std::size_t count() const override { return count_; }
    Bounds bounds(std::size_t) const override { throw SceneError("is asked for a box"); }
    Hull hull(std::size_t) const override { throw SceneError("is asked for a hull"); }
    void write_lane(std::size_t, uint, std::byte *) const override { throw SceneError("is asked for a lane"); }
    void write_shading(std::size_t, uint *, SharedTables &) const override { throw SceneError("is asked for shading"); }
    std::vector<Light> light(uint, std::vector<EmissiveFace> &) const override { return {}; }

private:
    std::size_t count_;
};

TEST(Sizes, MorePrimitivesThanNumbersAreRefused) {
    Scene scene = empty_scene();
    scene.file = "crowd.ply";
    scene.shapes.push_back(std::make_unique<Crowd>(MAX_PRIMITIVES));
    EXPECT_EQ(least_sizes(scene).primitives, MAX_PRIMITIVES);
    scene.shapes.push_back(std::make_unique<Crowd>(1));
    EXPECT_EQ(error_of([&] { compile(scene); }), "crowd.ply: 268435456 primitives are too many: at most 268435455 have numbers");
}

}  // namespace
}  // namespace brandung
