#include "scene/accelerators/reinsertion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/accelerators.h"
#include "tests/support/references.h"

namespace brandung {
namespace {

/// Of all nodes that are no leaves.
double sum_of_areas(const Bvh2 &tree, uint index) {
    const Bvh2Node &node = tree.nodes[index];
    return node.children == 0 ? 0 : tree.area(node) + sum_of_areas(tree, node.children) + sum_of_areas(tree, node.children + 1);
}

uint depth_below(const Bvh2 &tree, uint index) {
    const uint children = tree.nodes[index].children;
    return children == 0 ? 0 : 1 + std::max(depth_below(tree, children), depth_below(tree, children + 1));
}

/// Notes which references the leaves hold, and expects boxes and numbers to be right.
Bounds examine(const Bvh2 &tree, uint index, const References &references, std::vector<uint> &found) {
    const Bvh2Node &node = tree.nodes[index];
    Bounds bounds;
    if (node.children == 0) {
        for (uint i = node.first; i < node.first + node.count; ++i) {
            bounds.add(references[tree.references[i].index].bounds);
            ++found[tree.references[i].index];
        }
    } else {
        for (const uint child : {node.children, node.children + 1}) bounds.add(examine(tree, child, references, found));
        EXPECT_EQ(node.count, tree.nodes[node.children].count + tree.nodes[node.children + 1].count);
    }
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(node.box.low[axis], bounds.low[axis]);
        EXPECT_EQ(node.box.high[axis], bounds.high[axis]);
    }
    return bounds;
}

TEST(Reinsertion, KeepsTreesWholeAndMakesThemCheaper) {
    for (const auto &[name, references] : references_cases()) {
        Bvh2 tree = build_bvh2(references, {.slack = 16, .smallest_divided = 5}, unwatched);
        const double before = sum_of_areas(tree, 0);
        const uint limit = depth_limit(references.size(), 16);
        reinsert(tree, limit, unwatched);
        std::vector<uint> found(references.size());
        examine(tree, 0, references, found);
        EXPECT_TRUE(std::ranges::all_of(found, [](uint times) { return times == 1; })) << name;
        EXPECT_LE(sum_of_areas(tree, 0), before * 1.00001) << name;
        EXPECT_LE(depth_below(tree, 0), limit) << name;
    }
}

/// Eight boxes in one place.
void add_leaf(Bvh2 &tree, uint node, float x) {
    const uint first = node * BLOCK_SIZE;
    const KindBox box{Point4{x, 0, 0, 0}, Point4{x + 1, 1, 1, 0}};
    for (uint i = first; i < first + BLOCK_SIZE; ++i) tree.references[i] = {box, i};
    tree.nodes[node] = {box, first, BLOCK_SIZE, 0};
}

void add_inner(Bvh2 &tree, uint node, uint children) {
    KindBox box = tree.nodes[children].box;
    box.add(tree.nodes[children + 1].box);
    tree.nodes[node] = {box, 0, tree.nodes[children].count + tree.nodes[children + 1].count, children};
}

/// Places along the x axis, two and two of which are neighbours, but not siblings.
Bvh2 crossed_pairs() {
    Bvh2 tree{make_large_array<SortedReference>(7 * BLOCK_SIZE), make_large_array<Bvh2Node>(7), 7, {}};
    add_leaf(tree, 3, 0), add_leaf(tree, 4, 100);
    add_leaf(tree, 5, 1), add_leaf(tree, 6, 101);
    add_inner(tree, 1, 3), add_inner(tree, 2, 5);
    add_inner(tree, 0, 1);
    tree.area_of = RelativeArea(tree.nodes[0].box);
    return tree;
}

TEST(Reinsertion, NeighboursBecomeSiblings) {
    Bvh2 tree = crossed_pairs();
    reinsert(tree, 3, unwatched);
    for (const uint child : {tree.nodes[0].children, tree.nodes[0].children + 1})
        EXPECT_EQ(tree.nodes[child].box.high[0] - tree.nodes[child].box.low[0], 2);
}

/// Both pairs can be made only by way of a tree of three levels.
TEST(Reinsertion, NothingComesToLieTooDeep) {
    Bvh2 tree = crossed_pairs();
    reinsert(tree, 2, unwatched);
    for (const uint child : {tree.nodes[0].children, tree.nodes[0].children + 1})
        EXPECT_EQ(tree.nodes[child].box.high[0] - tree.nodes[child].box.low[0], 101);
}

}  // namespace
}  // namespace brandung
