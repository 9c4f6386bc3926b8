/// Which traversal a render takes, by device and accelerator.
#include "runtime/accelerators/traversals.h"

#include <gtest/gtest.h>

namespace brandung {
namespace {

const DeviceInfo cpu{.cpu = true}, gpu{.cpu = false};

std::string chosen(bool coherent, const DeviceInfo &device, const char *accelerator) {
    return traversal_of_render(coherent, device, find_accelerator(accelerator)).name;
}

TEST(Traversals, ACpuTakesPacketsWhereRaysStayTogetherAndTurnsWhereTheyDoNot) {
    EXPECT_EQ(chosen(true, cpu, "wide_bvh"), "packets");
    EXPECT_EQ(chosen(false, cpu, "wide_bvh"), "interleaved");
    EXPECT_EQ(chosen(true, cpu, "none"), "packets");
    EXPECT_EQ(chosen(false, cpu, "none"), "single");
    EXPECT_EQ(chosen(true, cpu, "octree"), "single");
}

TEST(Traversals, OtherDevicesTakeTheScalarOneWhereThereIsOne) {
    for (const bool coherent : {false, true}) {
        EXPECT_EQ(chosen(coherent, gpu, "wide_bvh"), "scalar");
        for (const AcceleratorKind &kind : accelerator_kinds())
            EXPECT_EQ(chosen(coherent, gpu, kind.name), kind.scalar ? "scalar" : "single") << kind.name;
    }
}

TEST(Traversals, ACpuCanTryAllThatAnAcceleratorHasAndOtherDevicesThoseThatPayThere) {
    const auto available = [](const DeviceInfo &device, const char *accelerator) {
        std::string names;
        for (const Traversal &traversal : traversals())
            if (is_available(traversal, device, find_accelerator(accelerator))) names += std::string(traversal.name) + " ";
        return names;
    };
    EXPECT_EQ(available(cpu, "wide_bvh"), "packets interleaved scalar single ");
    EXPECT_EQ(available(cpu, "none"), "packets single ");
    EXPECT_EQ(available(cpu, "kd_tree"), "single ");
    EXPECT_EQ(available(gpu, "wide_bvh"), "scalar single ");
    EXPECT_EQ(available(gpu, "none"), "single ");
}

TEST(Traversals, WhatACpuTakesHasEightLanes) {
    for (const AcceleratorKind &kind : accelerator_kinds())
        for (const bool coherent : {false, true}) EXPECT_EQ(traversal_of_render(coherent, cpu, kind).lanes, RayLanes::eight) << kind.name;
}

TEST(Traversals, ADeviceIsToldFromItsType) {
    EXPECT_TRUE(Device::select().info().cpu);
    const Device device = Device::select("", 0, true);
    EXPECT_FALSE(device.info().cpu);
    EXPECT_EQ(device.items_per_work_item(), 1u);
}

}  // namespace
}  // namespace brandung
