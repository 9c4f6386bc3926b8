#include "scene/accelerators/wide_cut.h"

#include <tbb/parallel_invoke.h>

namespace brandung {
namespace {

constexpr uint serial_below = 4096;  ///< references of a subtree that is one task

/// The cheapest way to make `width` children of the two binary children.
float share(const Cut &first, const Cut &second, uint width, uint8_t &first_share) {
    float best = FLT_MAX;
    for (uint j = 1; j < width; ++j) {
        const float cost = first.cost[j] + second.cost[width - j];
        if (cost < best) {
            best = cost;
            first_share = uint8_t(j);
        }
    }
    return best;
}

Cut cut_leaf(float area) {
    Cut cut{.cost = {}, .shares = {}, .is_leaf = true};
    cut.cost.fill(area);
    return cut;
}

Cut cut_inner(float area, bool fits_block, const Cut &first, const Cut &second) {
    Cut cut{.cost = {}, .shares = {}, .is_leaf = false};
    const float as_node = area + share(first, second, BVH_WIDTH, cut.shares[BVH_WIDTH]);
    cut.is_leaf = fits_block && area <= as_node;
    cut.cost[1] = cut.is_leaf ? area : as_node;
    for (uint j = 2; j < BVH_WIDTH; ++j) {
        cut.cost[j] = share(first, second, j, cut.shares[j]);
        if (cut.cost[1] <= cut.cost[j]) {
            cut.cost[j] = cut.cost[1];
            cut.shares[j] = 0;
        }
    }
    return cut;
}

void cut_subtree(const Bvh2 &tree, uint index, Cut *cuts) {
    const Bvh2Node &node = tree.nodes[index];
    const uint children = node.children;
    if (children == 0) {
        cuts[index] = cut_leaf(tree.area(node));
        return;
    }
    const auto cut_first = [&] { cut_subtree(tree, children, cuts); };
    const auto cut_second = [&] { cut_subtree(tree, children + 1, cuts); };
    if (node.count < serial_below) {
        cut_first();
        cut_second();
    } else {
        tbb::parallel_invoke(cut_first, cut_second);
    }
    cuts[index] = cut_inner(tree.area(node), node.fits_block(), cuts[children], cuts[children + 1]);
}

}  // namespace

LargeArray<Cut> cut_tree(const Bvh2 &tree) {
    auto cuts = make_large_array<Cut>(tree.node_count);
    cut_subtree(tree, 0, cuts.get());
    return cuts;
}

}  // namespace brandung
