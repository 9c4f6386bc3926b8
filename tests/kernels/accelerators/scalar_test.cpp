/// The scalar traversal of wide_bvh: its stack, and its order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "kernels/accelerators/wide_bvh.h"
#include "runtime/accelerators/ray_tracing.h"
#include "tests/support/probe.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {
namespace {

enum class NextNode { first, last };

/// As deep as a tree may be: every node has the next one as a child, beside leaves. All boxes hold everything, so that every ray comes everywhere,
/// with something left to do at every node above.
std::vector<BvhNode> chain_above(uint blocks, NextNode next) {
    std::vector<BvhNode> nodes(BVH_LEVELS);
    for (uint level = 0; level < BVH_LEVELS; ++level) {
        BvhNode &node = nodes[level];
        std::vector<uint> children;
        for (uint block = level; block < blocks; block += BVH_LEVELS) children.push_back(BVH_LEAF | block);
        if (level + 1 < BVH_LEVELS) children.insert(next == NextNode::first ? children.begin() : children.end(), level + 1);
        EXPECT_LE(children.size(), BVH_WIDTH);
        for (uint slot = 0; slot < BVH_WIDTH; ++slot) {
            const bool used = slot < children.size();
            node.child[slot] = used ? children[slot] : BVH_EMPTY;
            for (uint axis = 0; axis < 3; ++axis) node.high[axis][slot] = used ? 10 : -INFINITY, node.low[axis][slot] = -node.high[axis][slot];
        }
    }
    return nodes;
}

CompiledScene with_nodes(CompiledScene compiled, const std::vector<BvhNode> &nodes) {
    compiled.arena.resize((compiled.arena.size() + 63) / 64 * 64);
    compiled.header.world.nodes = {uint(compiled.arena.size() / 64), uint(nodes.size())};
    const auto bytes = std::as_bytes(std::span(nodes));
    compiled.arena.insert(compiled.arena.end(), bytes.begin(), bytes.end());
    return compiled;
}

std::vector<Ray> random_rays() {
    Random random(3);
    std::vector<Ray> rays;
    for (uint i = 0; i < 4096; ++i) rays.push_back(make_ray(random.in_cube(2), random.direction(), i % 3 == 0 ? 0.7f : INFINITY));
    return rays;
}

TEST(Scalar, TheStackHoldsTheDeepestTree) {
    Scene scene = empty_scene();
    add_soup(scene, 0, {.counts = {{"sphere", 400}}});
    const std::vector<Ray> rays = random_rays();
    const std::vector<Hit> expected = TracedScene(scene, "none").closest_hits(rays);
    scene.accelerator = "wide_bvh";
    const CompiledScene compiled = compile(scene);
    const uint blocks = compiled.header.world.blocks[0].count;
    ASSERT_GT(blocks, 2 * BVH_LEVELS) << "with leaves at every node";
    for (const NextNode next : {NextNode::first, NextNode::last}) {
        TracedScene traced(with_nodes(compiled, chain_above(blocks, next)));
        for (const Traversal &traversal : traced.traversals()) {
            const std::vector<Hit> hits = traced.closest_hits(traversal, rays);
            const std::vector<std::uint8_t> visible = traced.visible(traversal, rays);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                ASSERT_EQ(std::memcmp(&hits[i], &expected[i], sizeof(Hit)), 0) << traversal.name << ", ray " << i;
                ASSERT_EQ(visible[i] != 0, expected[i].primitive == NO_HIT) << traversal.name << ", ray " << i;
            }
        }
    }
}

/// Primitives and boxes are met in the order of the single traversal, but for those that are entered at the same t.
TEST(Scalar, VisitsWhatTheSingleOneVisits) {
    Scene scene = empty_scene();
    add_soup(scene, 0, {.counts = {{"triangle", 20000}}, .size = 0.1f});
    const CompiledScene compiled = compile(scene);
    const std::vector<Ray> rays = random_rays();
    const std::vector<uint> sources(rays.size(), 0);
    for (const bool shadow : {false, true}) {
        WorkSums one, eight;
        for (const auto &[lanes, sums] : {std::pair(RayLanes::one, &one), std::pair(RayLanes::eight, &eight)}) {
            const DeviceScene on_device(test_device(), compiled, lanes);
            RayTracing(test_device(), compiled, on_device, uint(rays.size())).count({shadow, false, rays, sources}, *sums);
        }
        EXPECT_EQ(one.hits, eight.hits);
        EXPECT_NEAR(double(one.steps), double(eight.steps), 0.02 * double(eight.steps));
        EXPECT_NEAR(double(one.tests), double(eight.tests), 0.02 * double(eight.tests));
        EXPECT_GT(one.tests, rays.size());
    }
}

}  // namespace
}  // namespace brandung
