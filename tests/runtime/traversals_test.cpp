/// Which traversal a render takes, by device and accelerator.
#include "runtime/accelerators/traversals.h"

#include <gtest/gtest.h>

namespace brandung {
namespace {

const DeviceInfo cpu{.cpu = true}, gpu{.cpu = false};

CompiledScene scene_of(const char *accelerator, std::size_t primitives, bool instances = false) {
    CompiledScene scene;
    scene.accelerator = &find_accelerator(accelerator);
    scene.primitive_count = primitives;
    scene.instances = instances;
    return scene;
}

std::string chosen(bool coherent, const DeviceInfo &device, const char *accelerator, std::size_t primitives = 100) {
    return traversal_of_render(coherent, device, scene_of(accelerator, primitives)).name;
}

TEST(Traversals, ACpuTakesPacketsWhereRaysStayTogetherAndTurnsWhereTheyDoNot) {
    EXPECT_EQ(chosen(true, cpu, "wide_bvh"), "packets");
    EXPECT_EQ(chosen(false, cpu, "wide_bvh"), "interleaved");
    EXPECT_EQ(chosen(true, cpu, "none"), "packets");
    EXPECT_EQ(chosen(false, cpu, "none"), "single");
    EXPECT_EQ(chosen(true, cpu, "octree"), "single");
}

TEST(Traversals, ACpuGoesThroughFewPrimitivesInRows) {
    EXPECT_EQ(chosen(false, cpu, "wide_bvh", 48), "rows");
    EXPECT_EQ(chosen(false, cpu, "wide_bvh", 49), "interleaved");
    EXPECT_EQ(chosen(true, cpu, "wide_bvh", 48), "packets");
    EXPECT_EQ(chosen(false, cpu, "none", 48), "rows");
    EXPECT_EQ(chosen(false, cpu, "none", 49), "single");
    EXPECT_EQ(chosen(false, cpu, "kd_tree", 48), "single");
    EXPECT_EQ(chosen(false, gpu, "wide_bvh", 48), "scalar");
    EXPECT_EQ(std::string(traversal_of_render(false, cpu, scene_of("wide_bvh", 48, true)).name), "interleaved");
}

TEST(Traversals, ACpuMeetsPrimitivesAtTheRootInRows) {
    CompiledScene scene = scene_of("wide_bvh", 100);
    scene.blocks_at_root = true;
    EXPECT_EQ(std::string(traversal_of_render(false, cpu, scene).name), "root_rows");
    EXPECT_EQ(std::string(traversal_of_render(true, cpu, scene).name), "packets");
    EXPECT_EQ(std::string(traversal_of_render(false, gpu, scene).name), "scalar");
    scene.instances = true;
    EXPECT_EQ(std::string(traversal_of_render(false, cpu, scene).name), "interleaved");
}

TEST(Traversals, OtherDevicesTakeTheScalarOneWhereThereIsOne) {
    for (const bool coherent : {false, true}) {
        EXPECT_EQ(chosen(coherent, gpu, "wide_bvh"), "scalar");
        for (const AcceleratorKind &kind : accelerator_kinds())
            EXPECT_EQ(chosen(coherent, gpu, kind.name), kind.scalar ? "scalar" : "single") << kind.name;
    }
}

TEST(Traversals, ACpuCanTryAllThatAnAcceleratorHasAndOtherDevicesThoseThatPayThere) {
    const auto available = [](const DeviceInfo &device, const char *accelerator, std::size_t primitives = 100) {
        std::string names;
        for (const Traversal &traversal : traversals())
            if (is_available(traversal, device, scene_of(accelerator, primitives))) names += std::string(traversal.name) + " ";
        return names;
    };
    EXPECT_EQ(available(cpu, "wide_bvh"), "packets rows root_rows interleaved scalar single ");
    EXPECT_EQ(available(cpu, "wide_bvh", 5000), "packets root_rows interleaved scalar single ");
    EXPECT_EQ(available(cpu, "none"), "packets rows single ");
    EXPECT_EQ(available(cpu, "kd_tree"), "single ");
    EXPECT_EQ(available(gpu, "wide_bvh"), "scalar single ");
    EXPECT_EQ(available(gpu, "none"), "single ");
}

TEST(Traversals, WhatACpuTakesHasEightLanes) {
    for (const AcceleratorKind &kind : accelerator_kinds())
        for (const bool coherent : {false, true})
            for (const std::size_t primitives : {1, 100})
                EXPECT_EQ(traversal_of_render(coherent, cpu, scene_of(kind.name, primitives)).lanes, RayLanes::eight) << kind.name;
}

TEST(Traversals, ADeviceIsToldFromItsType) {
    EXPECT_TRUE(Device::select().info().cpu);
    const Device device = Device::select("", 0, true);
    EXPECT_FALSE(device.info().cpu);
    EXPECT_EQ(device.items_per_work_item(), 1u);
}

}  // namespace
}  // namespace brandung
