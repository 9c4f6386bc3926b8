/// Collapses the binary hierarchy to nodes with 8 children.
#include "kernels/accelerators/wide_bvh.h"

#include <fmt/format.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <limits>

#include "scene/accelerators/bvh2.h"
#include "scene/error.h"

namespace brandung {
namespace {

constexpr uint serial_below = 4096;  ///< references of a subtree that is one task
constexpr uint most_slack = 16;

/// How to cut the binary tree into wide nodes at the least expected cost of a ray, a node and a block costing the same: Ylitie, Karras, Laine,
/// Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs (HPG 2017), section 3.1. It has fewer nodes than opening the
/// largest child until there are 8, and rays need fewer steps.
struct Cut {
    std::array<double, BVH_WIDTH> cost;         ///< [j]: of the subtree as up to j children of one wide node; j > 0
    std::array<uint8_t, BVH_WIDTH + 1> shares;  ///< [j]: so many of the j go to the first binary child; 0: the subtree is one child
    bool is_leaf;                               ///< as one child it is a block, not a node
};

/// The cheapest way to make `width` children of the two binary children.
double share(const Cut &first, const Cut &second, uint width, uint8_t &first_share) {
    double best = DBL_MAX;
    for (uint j = 1; j < width; ++j) {
        const double cost = first.cost[j] + second.cost[width - j];
        if (cost < best) {
            best = cost;
            first_share = uint8_t(j);
        }
    }
    return best;
}

Cut cut_leaf(double area) {
    Cut cut{.cost = {}, .shares = {}, .is_leaf = true};
    cut.cost.fill(area);
    return cut;
}

Cut cut_inner(double area, bool fits_block, const Cut &first, const Cut &second) {
    Cut cut{.cost = {}, .shares = {}, .is_leaf = false};
    const double as_node = area + share(first, second, BVH_WIDTH, cut.shares[BVH_WIDTH]);
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

struct Collapse {
    const Bvh2 &tree;
    BuildProgress &progress;
    std::unique_ptr<Cut[]> cuts;
    std::array<std::vector<PrimitiveBlock>, MAX_PRIMITIVE_KINDS> blocks;
    std::vector<BvhNode> nodes;
    uint stack_entries = 1;  // that a ray needs if it meets all boxes and visits the children in the worst order

    Collapse(const Bvh2 &binary, BuildProgress &progress)
        : tree(binary), progress(progress), cuts(std::make_unique_for_overwrite<Cut[]>(binary.node_count)) {}
};

struct Children {
    std::array<uint, BVH_WIDTH> nodes;  // of the binary tree
    uint count = 0;
};

void add_children(const Collapse &collapse, uint index, uint width, Children &children) {
    const uint first_share = collapse.cuts[index].shares[width];
    if (first_share == 0) {
        children.nodes[children.count++] = index;
        return;
    }
    const uint first = collapse.tree.nodes[index].children;
    add_children(collapse, first, first_share, children);
    add_children(collapse, first + 1, width - first_share, children);
}

/// Largest first.
Children children_of(const Collapse &collapse, uint index) {
    Children children;
    if (collapse.cuts[index].is_leaf) {
        children = {.nodes = {index}, .count = 1};  // only the root has a node nevertheless
    } else {
        add_children(collapse, index, BVH_WIDTH, children);
    }
    const auto has_more = [&](uint a, uint b) { return collapse.tree.nodes[a].count > collapse.tree.nodes[b].count; };
    std::stable_sort(children.nodes.begin(), children.nodes.begin() + children.count, has_more);
    return children;
}

BvhNode empty_node() {
    BvhNode node{};
    for (auto &low : node.low) std::fill(std::begin(low), std::end(low), std::numeric_limits<float>::infinity());
    for (auto &high : node.high) std::fill(std::begin(high), std::end(high), -std::numeric_limits<float>::infinity());
    std::fill(std::begin(node.child), std::end(node.child), BVH_EMPTY);
    return node;
}

uint add_block(Collapse &collapse, const Bvh2Node &leaf) {
    const uint kind = leaf.box.kind();
    std::vector<PrimitiveBlock> &blocks = collapse.blocks[kind];
    if (blocks.size() == BVH_BLOCK) {  // the word of one more would be BVH_EMPTY in the last kind
        throw SceneError(fmt::format("wide_bvh: cannot hold more than {} blocks of {} primitives of one kind", BVH_BLOCK, BLOCK_SIZE));
    }
    PrimitiveBlock block{.references = {}, .count = leaf.count};
    for (uint i = 0; i < leaf.count; ++i) block.references[i] = collapse.tree.references[leaf.first + i].index;
    std::sort(block.references.begin(), block.references.begin() + leaf.count);
    blocks.push_back(block);
    collapse.progress.add(leaf.count);
    return BVH_LEAF | kind << BVH_KIND_SHIFT | uint(blocks.size() - 1);
}

/// Depth first, so that what is near in space is near in memory. `pending`: entries on the stack of a ray that arrives here.
uint add_node(Collapse &collapse, uint index, uint pending) {
    const Children children = children_of(collapse, index);
    const uint place = uint(collapse.nodes.size());
    collapse.nodes.push_back(empty_node());
    pending += children.count - 1;
    collapse.stack_entries = std::max(collapse.stack_entries, pending + 1);
    for (uint slot = 0; slot < children.count; ++slot) {
        const uint child = children.nodes[slot];
        const Bvh2Node &source = collapse.tree.nodes[child];
        const uint word = collapse.cuts[child].is_leaf ? add_block(collapse, source) : add_node(collapse, child, pending);
        BvhNode &node = collapse.nodes[place];
        node.child[slot] = word;
        for (uint axis = 0; axis < 3; ++axis) {
            node.low[axis][slot] = source.box.low[axis];
            node.high[axis][slot] = source.box.high[axis];
        }
    }
    return place;
}

BuiltAccelerator built(Collapse &collapse) {
    BuiltAccelerator accelerator{.blocks = std::move(collapse.blocks), .nodes = {}, .node_count = uint(collapse.nodes.size())};
    const auto bytes = std::as_bytes(std::span(collapse.nodes));
    accelerator.nodes.assign(bytes.begin(), bytes.end());
    return accelerator;
}

BuiltAccelerator build_empty(BuildProgress &progress) {
    const Bvh2 none;
    Collapse collapse(none, progress);
    collapse.nodes.push_back(empty_node());
    return built(collapse);
}

}  // namespace

BuiltAccelerator build_wide_bvh(std::span<const Reference> references, const Hulls &, BuildProgress &progress) {
    if (references.empty()) return build_empty(progress);
    progress.begin(2 * references.size());  // the binary tree, then its collapse
    // Only nests of boxes that grow without end make the first tree too deep.
    for (uint slack = most_slack;; slack /= 2) {
        const Bvh2 tree = build_bvh2(references, slack, progress);
        Collapse collapse(tree, progress);
        cut_subtree(tree, 0, collapse.cuts.get());
        add_node(collapse, 0, 0);
        if (collapse.stack_entries <= BVH_PENDING) return built(collapse);
        if (slack == 0) throw SceneError(fmt::format("wide_bvh: {} primitives need a deeper stack than the traversal has", references.size()));
    }
}

}  // namespace brandung
