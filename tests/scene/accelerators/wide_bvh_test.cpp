#include "kernels/accelerators/wide_bvh.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstring>
#include <functional>

#include "tests/support/accelerators.h"
#include "tests/support/references.h"

namespace brandung {
namespace {

BuiltAccelerator build(const References &references) { return build_accelerator("wide_bvh", references); }

std::vector<BvhNode> nodes_of(const BuiltAccelerator &built) {
    std::vector<BvhNode> nodes(built.node_count);
    EXPECT_EQ(built.nodes.size(), nodes.size() * sizeof(BvhNode));
    std::memcpy(nodes.data(), built.nodes.data(), built.nodes.size());
    return nodes;
}

Bounds box_of(const BvhNode &node, uint slot) {
    Bounds box;
    box.low = {node.low[0][slot], node.low[1][slot], node.low[2][slot]};
    box.high = {node.high[0][slot], node.high[1][slot], node.high[2][slot]};
    return box;
}

const PrimitiveBlock &block_of(const BuiltAccelerator &built, uint word) { return built.blocks[word >> BVH_KIND_SHIFT & 7u].at(word & BVH_BLOCK); }

/// The words before the first empty one.
std::span<const uint> children_of(const BvhNode &node) {
    return {std::begin(node.child), std::find(std::begin(node.child), std::end(node.child), BVH_EMPTY)};
}

class WideBvhOfCase : public testing::TestWithParam<ReferencesCase> {
protected:
    const References &references = GetParam().references;
    const BuiltAccelerator built = build(references);
    const std::vector<BvhNode> nodes = nodes_of(built);

    Bounds bounds_below(uint word) const {
        Bounds bounds;
        if (word & BVH_LEAF) {
            const PrimitiveBlock &block = block_of(built, word);
            for (uint i = 0; i < block.count; ++i) bounds.add(references[block.references[i]].bounds);
            return bounds;
        }
        for (const uint child : children_of(nodes[word])) bounds.add(bounds_below(child));
        return bounds;
    }
    uint primitives_below(uint word) const {
        if (word & BVH_LEAF) return block_of(built, word).count;
        uint sum = 0;
        for (const uint child : children_of(nodes[word])) sum += primitives_below(child);
        return sum;
    }
    // Entries on a ray's stack if it meets everything and visits the children in the worst order.
    uint stack_entries(uint word) const {
        if (word & BVH_LEAF) return 1;
        uint most = 0;
        for (const uint child : children_of(nodes[word])) most = std::max(most, stack_entries(child));
        return uint(children_of(nodes[word]).size()) - 1 + most;
    }
};
INSTANTIATE_TEST_SUITE_P(, WideBvhOfCase, testing::ValuesIn(references_cases()), [](const auto &info) { return info.param.name; });

TEST_P(WideBvhOfCase, EveryReferenceIsInOneBlockOfItsKindInAscendingOrder) {
    std::vector<uint> found(references.size());
    for (uint kind = 0; kind < MAX_PRIMITIVE_KINDS; ++kind) {
        for (const PrimitiveBlock &block : built.blocks[kind]) {
            ASSERT_GE(block.count, 1u);
            ASSERT_LE(block.count, BLOCK_SIZE);
            for (uint i = 0; i < block.count; ++i) {
                ASSERT_EQ(references.at(block.references[i]).kind, kind);
                ASSERT_TRUE(i == 0 || block.references[i - 1] < block.references[i]);
                ++found[block.references[i]];
            }
        }
    }
    EXPECT_TRUE(std::all_of(found.begin(), found.end(), [](uint times) { return times == 1; }));
}

TEST_P(WideBvhOfCase, DepthFirstOrderMeetsEveryBlockAndNodeOnceInTheOrderOfTheirNumbers) {
    std::array<uint, MAX_PRIMITIVE_KINDS> next_block{};
    uint next_node = 1;
    const auto visit = [&](const auto &self, uint node) -> void {
        ASSERT_GE(children_of(nodes[node]).size(), node == 0 ? 1u : 2u);
        for (const uint word : children_of(nodes[node])) {
            if (word & BVH_LEAF) {
                ASSERT_EQ(word & BVH_BLOCK, next_block[word >> BVH_KIND_SHIFT & 7u]++);
            } else {
                ASSERT_EQ(word, next_node++);
                self(self, word);
            }
        }
    };
    visit(visit, 0);
    EXPECT_EQ(next_node, built.node_count);
    for (uint kind = 0; kind < MAX_PRIMITIVE_KINDS; ++kind) EXPECT_EQ(next_block[kind], built.blocks[kind].size());
}

TEST_P(WideBvhOfCase, EmptyChildrenAreLastAndHaveFiniteBoxes) {
    for (const BvhNode &node : nodes) {
        for (uint slot = uint(children_of(node).size()); slot < BVH_WIDTH; ++slot) {
            ASSERT_EQ(node.child[slot], BVH_EMPTY);
            ASSERT_TRUE(box_of(node, slot).low == vec3(0) && box_of(node, slot).high == vec3(0));
        }
    }
}

TEST_P(WideBvhOfCase, BoxesAreTheExactUnionsOfTheirReferences) {
    for (const BvhNode &node : nodes) {
        for (uint slot = 0; slot < children_of(node).size(); ++slot) {
            const Bounds expected = bounds_below(node.child[slot]), box = box_of(node, slot);
            ASSERT_TRUE(box.low == expected.low && box.high == expected.high);
        }
    }
}

TEST_P(WideBvhOfCase, ChildrenAreSortedByTheNumberOfPrimitivesLargestFirst) {
    for (const BvhNode &node : nodes)
        EXPECT_TRUE(std::ranges::is_sorted(children_of(node), std::greater(), [&](uint word) { return primitives_below(word); }));
}

TEST_P(WideBvhOfCase, TheTraversalsStackIsDeepEnough) { EXPECT_LE(stack_entries(0), BVH_PENDING); }

TEST_P(WideBvhOfCase, TheNumberOfThreadsDoesNotShow) {
    for (const size_t threads : {1, 2}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const BuiltAccelerator again = build(references);
        EXPECT_EQ(again.nodes, built.nodes);
        for (uint kind = 0; kind < MAX_PRIMITIVE_KINDS; ++kind) {
            const auto same = [](const PrimitiveBlock &a, const PrimitiveBlock &b) { return a.count == b.count && a.references == b.references; };
            EXPECT_TRUE(std::ranges::equal(again.blocks[kind], built.blocks[kind], same));
        }
    }
}

TEST(WideBvh, NoReferencesMakeARootWithoutChildren) {
    const std::vector<BvhNode> nodes = nodes_of(build({}));
    ASSERT_EQ(nodes.size(), 1u);
    EXPECT_TRUE(children_of(nodes[0]).empty());
}

TEST(WideBvh, TheSignOfAZeroDoesNotShow) {
    References references = scaled(random_boxes(1'000, 1, 0.01f), {1, 1, 0});
    const BuiltAccelerator expected = build(references);
    for (uint i = 0; i < references.size(); i += 2) references[i].bounds.low.z = -0.0f;
    EXPECT_EQ(build(references).nodes, expected.nodes);
}

TEST(WideBvh, TwoKindsInOnePlaceAreSplitByKind) {
    // 8 of each in one place are two full blocks; a split in space would leave four halves.
    References references(16, {{vec3(0), vec3(1)}, 0});
    for (uint i = 0; i < references.size(); ++i) references[i].kind = i % 2;
    const BuiltAccelerator built = build(references);
    EXPECT_EQ(built.node_count, 1u);
    EXPECT_EQ(built.blocks[0].size(), 1u);
    EXPECT_EQ(built.blocks[1].size(), 1u);
}

TEST(WideBvh, CoincidingReferencesFillTheirBlocks) { EXPECT_EQ(build(References(1'003, {{vec3(1), vec3(2)}, 0})).blocks[0].size(), 126u); }

}  // namespace
}  // namespace brandung
