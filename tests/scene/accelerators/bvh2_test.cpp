#include "scene/accelerators/bvh2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/accelerators.h"
#include "tests/support/references.h"

namespace brandung {
namespace {

/// Denser and smaller toward a corner: areas tell that, counts don't.
References crowded_boxes(uint count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0, 1);
    References references(count);
    for (uint i = 0; i < count; ++i) {
        const float scale = std::pow(unit(random), 4.0f);
        const vec3 low = scale * vec3(unit(random), unit(random), unit(random));
        references[i] = {{low, low + vec3(0.1f * scale)}, 0};
    }
    return references;
}

uint depth_below(const Bvh2 &tree, uint index) {
    const uint children = tree.nodes[index].children;
    return children == 0 ? 0 : 1 + std::max(depth_below(tree, children), depth_below(tree, children + 1));
}

/// What a ray visits on average, up to a factor: blocks and the nodes above them.
double cost_of(const Bvh2 &tree, uint index) {
    const Bvh2Node &node = tree.nodes[index];
    return tree.area(node) + (node.fits_block() ? 0 : cost_of(tree, node.children) + cost_of(tree, node.children + 1));
}

double half_area(const Bounds &bounds) {
    const glm::dvec3 edges(bounds.high - bounds.low);
    return edges.x * edges.y + edges.y * edges.z + edges.z * edges.x;
}

/// The same for ranges halved at the median of their longest edge.
double median_cost_of(std::span<Reference> references) {
    Bounds bounds;
    for (const Reference &reference : references) bounds.add(reference.bounds);
    if (references.size() <= BLOCK_SIZE) return half_area(bounds);
    const vec3 edges = bounds.high - bounds.low;
    const int axis = edges.x >= edges.y && edges.x >= edges.z ? 0 : edges.y >= edges.z ? 1 : 2;
    const auto centre = [&](const Reference &reference) { return reference.bounds.low[axis] + reference.bounds.high[axis]; };
    const size_t half = references.size() / 2;
    std::ranges::nth_element(references, references.begin() + half, {}, centre);
    return half_area(bounds) + median_cost_of(references.first(half)) + median_cost_of(references.subspan(half));
}

TEST(Bvh2, CostsLessThanHalvesAtTheMedian) {
    References references = crowded_boxes(16'384);  // a power of two, with which halves have full blocks
    const double cost = cost_of(build_bvh2(references, {.slack = 16}, unwatched), 0);
    EXPECT_LT(cost, 0.93 * median_cost_of(references));  // measured: 0.88
}

TEST(Bvh2, SplitsWhereThereIsNothing) {
    References references = crowded_boxes(16'384);
    for (uint i = 0; i < 1'000; ++i) references[i].bounds = {references[i].bounds.low + vec3(5), references[i].bounds.high + vec3(5)};
    const Bvh2 tree = build_bvh2(references, {.slack = 16}, unwatched);
    EXPECT_EQ(tree.nodes[tree.nodes[0].children].count, 15'384u);
    EXPECT_EQ(tree.nodes[tree.nodes[0].children + 1].count, 1'000u);
}

TEST(Bvh2, IsNoDeeperThanAllowed) {
    const References references = nest(2'000);  // 11 levels if balanced
    EXPECT_GT(depth_below(build_bvh2(references, {.slack = 1'000}, unwatched), 0), 30u);
    EXPECT_LE(depth_below(build_bvh2(references, {.slack = 16}, unwatched), 0), 27u);
    EXPECT_LE(depth_below(build_bvh2(references, {.slack = 0}, unwatched), 0), 11u);
}

TEST(Bvh2, HasParentsBeforeTheirChildrenAndRangesThatAddUp) {
    const Bvh2 tree = build_bvh2(crowded_boxes(20'000), {.slack = 16}, unwatched);
    for (uint i = 0; i < tree.node_count; ++i) {
        const Bvh2Node &node = tree.nodes[i];
        if (node.children == 0) {
            EXPECT_TRUE(node.fits_block());
            continue;
        }
        const Bvh2Node &first = tree.nodes[node.children], &second = tree.nodes[node.children + 1];
        EXPECT_GT(node.children, i);
        EXPECT_EQ(first.first, node.first);
        EXPECT_EQ(second.first, first.first + first.count);
        EXPECT_EQ(first.count + second.count, node.count);
    }
}

}  // namespace
}  // namespace brandung
