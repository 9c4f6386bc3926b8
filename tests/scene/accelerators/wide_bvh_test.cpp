#include "scene/accelerators/wide_bvh.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <random>
#include <string>
#include <tuple>

#include "kernels/primitives/triangle.h"
#include "scene/error.h"
#include "tests/support/accelerators.h"
#include "tests/support/references.h"

namespace brandung {
namespace {

BuiltAccelerator build(const References &references, BuildQuality quality = BuildQuality::fast) {
    return build_accelerator("wide_bvh", references, quality);
}

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

/// Nodes on the longest way from this one.
uint levels_from(const std::vector<BvhNode> &nodes, uint word) {
    if (word & BVH_LEAF) return 0;
    uint most = 0;
    for (const uint child : children_of(nodes[word])) most = std::max(most, levels_from(nodes, child));
    return 1 + most;
}

class WideBvhOfCase : public testing::TestWithParam<std::tuple<ReferencesCase, BuildQuality>> {
protected:
    const References &references = std::get<0>(GetParam()).references;
    const BuildQuality quality = std::get<1>(GetParam());
    const BuiltAccelerator built = build(references, quality);
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
INSTANTIATE_TEST_SUITE_P(, WideBvhOfCase,
                         testing::Combine(testing::ValuesIn(references_cases()), testing::Values(BuildQuality::fast, BuildQuality::high)),
                         [](const auto &info) { return std::string(std::get<0>(info.param).name) + "_" + name_of(std::get<1>(info.param)); });

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

TEST_P(WideBvhOfCase, EmptyChildrenAreLastAndTheirBoxesAreTurnedInsideOut) {
    for (const BvhNode &node : nodes) {
        for (uint slot = uint(children_of(node).size()); slot < BVH_WIDTH; ++slot) {
            ASSERT_EQ(node.child[slot], BVH_EMPTY);
            ASSERT_TRUE(box_of(node, slot).low == vec3(INFINITY) && box_of(node, slot).high == vec3(-INFINITY));
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

TEST_P(WideBvhOfCase, TheTraversalsStacksAreDeepEnough) {
    EXPECT_LE(stack_entries(0), BVH_PENDING);
    EXPECT_LE(levels_from(nodes, 0), BVH_LEVELS);
}

TEST_P(WideBvhOfCase, TheNumberOfThreadsDoesNotShow) {
    for (const size_t threads : {1, 2}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const BuiltAccelerator again = build(references, quality);
        EXPECT_EQ(again.nodes, built.nodes);
        for (uint kind = 0; kind < MAX_PRIMITIVE_KINDS; ++kind) {
            const auto same = [](const PrimitiveBlock &a, const PrimitiveBlock &b) { return a.count == b.count && a.references == b.references; };
            EXPECT_TRUE(std::ranges::equal(again.blocks[kind], built.blocks[kind], same));
        }
    }
}

TEST(WideBvh, ATreeThatIsTooDeepIsBuiltMoreBalanced) {
    const References references = nest(2'000);
    const uint levels = levels_from(nodes_of(build(references)), 0), fewer = levels - 1;
    const std::vector<BvhNode> nodes = nodes_of(build_wide_bvh_within({.levels = fewer}, references, BuildQuality::fast, unwatched));
    EXPECT_LE(levels_from(nodes, 0), fewer) << "of " << levels;
    EXPECT_THROW(build_wide_bvh_within({.levels = 1}, references, BuildQuality::fast, unwatched), SceneError);
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

/// What a ray visits on average, nodes and blocks, if it meets the root.
double expected_steps(const BuiltAccelerator &built) {
    const auto half_area = [](const Bounds &box) {
        const glm::dvec3 edges = glm::dvec3(box.high) - glm::dvec3(box.low);
        return edges.x * edges.y + edges.y * edges.z + edges.z * edges.x;
    };
    const std::vector<BvhNode> nodes = nodes_of(built);
    Bounds all;
    double sum = 0;
    for (const BvhNode &node : nodes) {
        for (uint slot = 0; slot < children_of(node).size(); ++slot) {
            if (&node == nodes.data()) all.add(box_of(node, slot));
            sum += half_area(box_of(node, slot));
        }
    }
    return 1 + sum / half_area(all);
}

/// Rods along the axes, of all lengths, which lie across each other.
References rods(uint count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0, 1);
    References references(count);
    for (uint i = 0; i < count; ++i) {
        const float length = std::pow(0.01f, unit(random));
        vec3 half(0.03f * length);
        half[int(i % 3)] = length / 2;
        const vec3 centre(unit(random), unit(random), unit(random));
        references[i] = {{centre - half, centre + half}, 0};
    }
    return references;
}

TEST(WideBvh, HighQualitySavesStepsWhereThingsLieAcrossEachOther) {
    const References references = rods(20'000);
    EXPECT_LT(expected_steps(build(references, BuildQuality::high)), 0.85 * expected_steps(build(references)));  // measured: 0.79
}

TEST(WideBvh, HighQualitySavesStepsAmongBoxesAtRandom) {
    for (const References &references : {random_boxes(20'000, 1, 0.02f), random_boxes(20'000, 3, 0.001f)})
        EXPECT_LT(expected_steps(build(references, BuildQuality::high)), 0.97 * expected_steps(build(references)));  // measured: 0.93, 0.91
}

/// The boxes of a height field's triangles.
References terrain(uint side) {
    References references;
    const auto height = [](uint x, uint y) { return 3 * std::sin(0.05f * float(x)) * std::cos(0.07f * float(y)); };
    const auto vertex = [&](uint x, uint y) { return vec3(float(x), float(y), height(x, y)); };
    for (uint y = 0; y < side; ++y) {
        for (uint x = 0; x < side; ++x) {
            for (const vec3 corner : {vertex(x, y), vertex(x + 1, y + 1)}) {
                Bounds bounds;
                for (const vec3 point : {vertex(x + 1, y), vertex(x, y + 1), corner}) bounds.add(point);
                references.push_back({bounds, 0});
            }
        }
    }
    return references;
}

/// Beside it: Embree 3.13 takes 67 for as many triangles of a mesh, without its vertices.
TEST(WideBvh, TakesFewBytesPerTriangle) {
    const References references = terrain(300);
    for (const auto &[quality, most] : {std::pair(BuildQuality::fast, 56.0), std::pair(BuildQuality::high, 66.0)}) {
        const BuiltAccelerator built = build(references, quality);
        const double bytes = double(built.nodes.size() + built.blocks[0].size() * sizeof(TriangleBlock)) / double(references.size());
        EXPECT_LT(bytes, most) << name_of(quality);
    }
}

TEST(WideBvh, CoincidingReferencesFillTheirBlocks) { EXPECT_EQ(build(References(1'003, {{vec3(1), vec3(2)}, 0})).blocks[0].size(), 126u); }

}  // namespace
}  // namespace brandung
