#include "kernels/accelerators/kd_tree.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>

#include "scene/accelerators/kd_split.h"
#include "tests/support/accelerators.h"
#include "tests/support/references.h"

namespace brandung {
namespace {

/// What a kernel reads.
class Tree {
public:
    explicit Tree(const BuiltAccelerator &built) : built_(built) { std::memcpy(&header, built.nodes.data(), sizeof header); }

    KdNode node(uint number) const { return at<KdNode>(header.spans.cells, number); }
    static bool is_leaf(KdNode node) { return (node.word & KD_AXIS) == KD_LEAF; }

    /// References in a leaf, ascending.
    std::vector<uint> listed(KdNode leaf) const {
        std::vector<uint> found;
        for (uint i = leaf.plane, item = 0; leaf.plane != NO_ITEMS && !(item & ITEM_LAST); ++i) {
            item = at<uint>(header.spans.items, i);
            const PrimitiveBlock &block = built_.blocks.at(item >> ITEM_KIND_SHIFT & 7u).at(item & ITEM_BLOCK);
            for (uint lane = 0; lane < BLOCK_SIZE; ++lane)
                if (at<std::uint8_t>(header.spans.lanes, i) >> lane & 1u) found.push_back(block.references.at(lane));
        }
        std::ranges::sort(found);
        return found;
    }

    /// Boxes, numbers and depths (of the root: 0) of all nodes.
    template <class See> void for_each(See see) const { walk(0, {header.low, header.high}, 0, see); }

    KdTree header;

private:
    template <class T> T at(uint place, std::size_t i) const {
        T value;
        std::memcpy(&value, &built_.nodes.at(place * sizeof(uint) + i * sizeof(T)), sizeof(T));
        return value;
    }
    template <class See> void walk(uint number, const Bounds &box, uint depth, See see) const {
        const KdNode node = this->node(number);
        see(node, number, box, depth);
        if (is_leaf(node)) return;
        const int axis = int(node.word & KD_AXIS);
        Bounds below = box, above = box;
        below.high[axis] = above.low[axis] = std::bit_cast<float>(node.plane);
        walk(node.word >> KD_CHILD_SHIFT, below, depth + 1, see);
        walk((node.word >> KD_CHILD_SHIFT) + 1, above, depth + 1, see);
    }

    const BuiltAccelerator &built_;
};

/// Whether a box has a part in a node's. A box which is flat along an axis and lies in a plane has one in the node below, or in the root that ends
/// there.
bool has_part_in(const Bounds &box, const Bounds &node, const Bounds &root) {
    for (int axis = 0; axis < 3; ++axis) {
        const float low = box.low[axis], high = box.high[axis];
        const bool begins_before = low < node.high[axis] || (low == high && low == node.high[axis]);
        const bool ends_behind = high > node.low[axis] || (low == high && node.low[axis] == low && root.low[axis] == low);
        if (!begins_before || !ends_behind) return false;
    }
    return true;
}

std::size_t listed_in_all(const Tree &tree) {
    std::size_t sum = 0;
    tree.for_each([&](KdNode node, uint, const Bounds &, uint) { sum += Tree::is_leaf(node) ? tree.listed(node).size() : 0; });
    return sum;
}

class KdTreeOfCase : public testing::TestWithParam<std::tuple<std::string, ReferencesCase>> {
protected:
    const References &references = std::get<1>(GetParam()).references;
    const BuiltAccelerator built = build_accelerator(std::get<0>(GetParam()), references);
    const Tree tree{built};
};
INSTANTIATE_TEST_SUITE_P(, KdTreeOfCase, testing::Combine(testing::Values("kd_tree", "kd_tree_median"), testing::ValuesIn(references_cases())),
                         [](const auto &info) { return std::get<0>(info.param) + "_" + std::get<1>(info.param).name; });

TEST_P(KdTreeOfCase, EveryReferenceIsInOneBlockOfItsKind) {
    std::vector<uint> found(references.size());
    for (uint kind = 0; kind < MAX_PRIMITIVE_KINDS; ++kind)
        for (const PrimitiveBlock &block : built.blocks[kind])
            for (uint i = 0; i < block.count; ++i) {
                ASSERT_EQ(references.at(block.references[i]).kind, kind);
                ++found[block.references[i]];
            }
    EXPECT_TRUE(std::ranges::all_of(found, [](uint times) { return times == 1; }));
}

TEST_P(KdTreeOfCase, PlanesLieInsideOfTheirNodesSoThatLeavesTileTheRoot) {
    Bounds all;
    for (const Reference &reference : references) all.add(reference.bounds);
    EXPECT_TRUE(tree.header.low == all.low && tree.header.high == all.high);
    std::vector<uint> found(built.node_count);
    tree.for_each([&](KdNode node, uint number, const Bounds &box, uint depth) {
        ++found.at(number);
        ASSERT_LE(depth, KD_DEPTH);
        if (Tree::is_leaf(node)) return;
        const float plane = std::bit_cast<float>(node.plane);
        ASSERT_TRUE(box.low[int(node.word & KD_AXIS)] < plane && plane < box.high[int(node.word & KD_AXIS)]);
        ASSERT_EQ(node.word >> KD_CHILD_SHIFT & 1u, 0u);
    });
    EXPECT_EQ(found[1], 0u);
    found[1] = 1;
    EXPECT_TRUE(std::ranges::all_of(found, [](uint times) { return times == 1; }));
}

TEST_P(KdTreeOfCase, LeavesListWhatHasAPartInThem) {
    const Bounds root{tree.header.low, tree.header.high};
    std::vector<uint> all(references.size());
    std::iota(all.begin(), all.end(), 0u);
    std::vector<std::vector<uint>> of_depth(KD_DEPTH + 2, all);  // those with a part in the ancestors of the node at hand
    std::size_t listed = 0;
    tree.for_each([&](KdNode node, uint, const Bounds &box, uint depth) {
        std::vector<uint> &inside = of_depth[depth + 1];
        inside.clear();
        std::ranges::copy_if(of_depth[depth], std::back_inserter(inside), [&](uint i) { return has_part_in(references[i].bounds, box, root); });
        if (!Tree::is_leaf(node)) return;
        ASSERT_EQ(tree.listed(node), inside);
        listed += inside.size();
    });
    EXPECT_GE(listed, references.size());
    EXPECT_LE(listed, 7 * references.size()) << "copies without end";
}

TEST_P(KdTreeOfCase, TheNumberOfThreadsDoesNotShow) {
    for (const size_t threads : {1, 2}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const BuiltAccelerator again = build_accelerator(std::get<0>(GetParam()), references);
        EXPECT_EQ(again.nodes, built.nodes);
        for (uint kind = 0; kind < MAX_PRIMITIVE_KINDS; ++kind) {
            const auto same = [](const PrimitiveBlock &a, const PrimitiveBlock &b) { return a.count == b.count && a.references == b.references; };
            EXPECT_TRUE(std::ranges::equal(again.blocks[kind], built.blocks[kind], same));
        }
    }
}

class KdTrees : public testing::TestWithParam<const char *> {};
INSTANTIATE_TEST_SUITE_P(, KdTrees, testing::Values("kd_tree", "kd_tree_median"), [](const auto &info) { return std::string(info.param); });

TEST_P(KdTrees, NoReferencesMakeAnEmptyLeaf) {
    const BuiltAccelerator built = build_accelerator(GetParam(), {});
    const Tree tree(built);
    EXPECT_TRUE(Tree::is_leaf(tree.node(0)));
    EXPECT_TRUE(tree.listed(tree.node(0)).empty());
    EXPECT_TRUE(tree.header.low == vec3(0) && tree.header.high == vec3(0));
}

TEST_P(KdTrees, CoincidingReferencesStayInOneLeafOfFullBlocks) {
    const BuiltAccelerator built = build_accelerator(GetParam(), References(1'003, {{vec3(1), vec3(2)}, 0}));
    EXPECT_TRUE(Tree::is_leaf(Tree(built).node(0)));
    EXPECT_EQ(built.blocks[0].size(), 126u);
}

/// What lies in all parts of the scene would be in every leaf.
TEST_P(KdTrees, LongBoxesAreNotCopiedWithoutEnd) {
    References references = random_boxes(4'000, 1, 0.01f);
    for (uint i = 0; i < references.size(); i += 2) references[i].bounds = {vec3(0, references[i].bounds.low.y, 0), vec3(1, 1, 1)};
    const BuiltAccelerator built = build_accelerator(GetParam(), references);
    EXPECT_LE(listed_in_all(Tree(built)), 7 * references.size());
}

/// Steps of a ray through the scene's box on average (of those through a box, as many as its area says), a leaf at the price that the builder sees.
double cost_of(const char *accelerator, const References &references) {
    const BuiltAccelerator built = build_accelerator(accelerator, references);
    const Tree tree(built);
    const auto half_area = [](const Bounds &box) {
        const glm::dvec3 edges(box.high - box.low);
        return edges.x * edges.y + edges.y * edges.z + edges.z * edges.x;
    };
    double sum = 0;
    tree.for_each([&](KdNode node, uint, const Bounds &box, uint) {
        const std::size_t listed = Tree::is_leaf(node) ? tree.listed(node).size() : 0;
        sum += half_area(box) * (1 + kd_leaf_cost(listed));
    });
    return sum / half_area({tree.header.low, tree.header.high});
}

TEST(KdTree, TheSurfaceAreaHeuristicIsCheaperThanTheMedian) {
    References references = random_boxes(4'000, 1, 0.02f);
    for (Reference &reference : references) {  // denser and smaller toward a corner
        const float scale = std::pow(reference.bounds.low.x, 4.0f);
        reference.bounds.low *= scale, reference.bounds.high *= scale;
    }
    EXPECT_LT(cost_of("kd_tree", references), 0.8 * cost_of("kd_tree_median", references));
}

TEST(KdTree, EmptySpaceIsCutOff) {
    // Two clusters in the corners: what is between them is nearly all of the box, and no leaf with references need reach there.
    References references = random_boxes(2'000, 1, 0.01f);
    for (uint i = 0; i < references.size(); ++i) {
        Bounds &box = references[i].bounds;
        box.low = 0.1f * box.low + (i % 2 ? 0.9f : 0.0f), box.high = 0.1f * box.high + (i % 2 ? 0.9f : 0.0f);
    }
    const BuiltAccelerator built = build_accelerator("kd_tree", references);
    double full = 0;
    Tree(built).for_each([&](KdNode node, uint, const Bounds &box, uint) {
        const glm::dvec3 edges(box.high - box.low);
        if (Tree::is_leaf(node) && node.plane != NO_ITEMS) full += edges.x * edges.y * edges.z;
    });
    // Of each cluster 0.1³, with the box's extent of 1 to a rounding.
    EXPECT_LT(full, 2 * 0.001 * 1.1);
}

}  // namespace
}  // namespace brandung
