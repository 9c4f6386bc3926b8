/// Builds kd-trees from the root down: a node's references go to the sides of its plane on which their boxes have a part.
#include "kernels/accelerators/kd_tree.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "scene/accelerators/cell_lists.h"
#include "scene/accelerators/kd_split.h"
#include "scene/error.h"

namespace brandung {
namespace {

constexpr std::size_t serial_below = 4096;  ///< references of a subtree that is one task
constexpr double copies_per_reference = 6;  ///< that planes may make, on average: what lies everywhere is in every leaf

/// A part of the tree: its root first, then nothing, then the rest in depth-first order, pairs of children at even places.
struct Subtree {
    std::vector<KdNode> nodes = {{NO_ITEMS, KD_LEAF}, {NO_ITEMS, KD_LEAF}};
    Cells leaves{{0}, {}};  ///< those with references, in depth-first order; the nodes have their numbers

    uint add_leaf(std::span<const KdReference> references) {
        for (const KdReference &reference : references) leaves.members.push_back(reference.index);
        leaves.starts.push_back(uint(leaves.members.size()));
        return uint(leaves.count() - 1);
    }

    /// Puts another's root in place of a node, and the rest behind.
    void append(uint node, const Subtree &other) {
        const uint nodes_before = uint(nodes.size()) - 2, leaves_before = uint(leaves.count()), members_before = leaves.starts.back();
        const auto moved = [&](KdNode moved) {
            if (moved.word != KD_LEAF)
                moved.word += nodes_before << KD_CHILD_SHIFT;
            else if (moved.plane != NO_ITEMS)
                moved.plane += leaves_before;
            return moved;
        };
        nodes[node] = moved(other.nodes[0]);
        std::transform(other.nodes.begin() + 2, other.nodes.end(), std::back_inserter(nodes), moved);
        leaves.members.insert(leaves.members.end(), other.leaves.members.begin(), other.leaves.members.end());
        std::transform(other.leaves.starts.begin() + 1, other.leaves.starts.end(), std::back_inserter(leaves.starts),
                       [&](uint start) { return members_before + start; });
    }
};

/// What is to be built below a node.
struct Part {
    std::vector<KdReference> references;
    Bounds box;
    uint depth;          ///< planes above
    double copies;       ///< of references that planes may still make below
    std::uint64_t work;  ///< for the progress
};

/// Both sides of a plane share what the node may spend by how much they have to do.
std::array<Part, 2> divided(const Part &part, const KdSplit &split) {
    const int axis = split.axis;
    std::array<Part, 2> sides;
    for (Part &side : sides) side.box = part.box, side.depth = part.depth + 1;
    sides[0].box.high[axis] = sides[1].box.low[axis] = split.plane;
    for (const KdReference &reference : part.references) {
        if (reference.is_below(axis, split.plane)) sides[0].references.push_back(reference);
        if (reference.is_above(axis, split.plane)) sides[1].references.push_back(reference);
    }
    const double below = double(sides[0].references.size()), sum = below + double(sides[1].references.size());
    const double copies = part.copies - (sum - double(part.references.size()));
    sides[0].copies = copies * (below / sum), sides[1].copies = copies - sides[0].copies;
    sides[0].work = std::uint64_t(double(part.work) * (below / sum)), sides[1].work = part.work - sides[0].work;
    return sides;
}

class KdBuild {
public:
    KdBuild(ChooseKdSplit choose, double pad, uint depth, BuildProgress &progress) : choose_(choose), pad_(pad), depth_(depth), progress_(progress) {}

    /// Puts a tree in place of a node, and all below behind.
    void build(Part part, Subtree &tree, uint node) const {
        if (part.references.empty()) return progress_.add(part.work);
        const KdSplit split = part.depth < depth_ ? choose_(part.references, part.box, pad_) : KdSplit{};
        if (!split.exists()) return add_leaf(part, tree, node);
        std::array<Part, 2> sides = divided(part, split);
        if (sides[0].copies + sides[1].copies < 0) return add_leaf(part, tree, node);
        const bool serial = part.references.size() < serial_below;
        part = {};
        const uint children = uint(tree.nodes.size());
        if (children + 2 > KD_NODES) throw SceneError(fmt::format("kd_tree: cannot hold more than {} nodes", KD_NODES));
        tree.nodes[node] = {std::bit_cast<uint>(split.plane), children << KD_CHILD_SHIFT | uint(split.axis)};
        tree.nodes.resize(children + 2, {NO_ITEMS, KD_LEAF});
        if (serial) {
            build(std::move(sides[0]), tree, children);
            build(std::move(sides[1]), tree, children + 1);
        } else {
            Subtree above;
            tbb::parallel_invoke([&] { build(std::move(sides[0]), tree, children); }, [&] { build(std::move(sides[1]), above, 0); });
            tree.append(children + 1, above);
        }
    }

private:
    void add_leaf(const Part &part, Subtree &tree, uint node) const {
        tree.nodes[node] = {tree.add_leaf(part.references), KD_LEAF};
        progress_.add(part.work);
    }

    ChooseKdSplit choose_;
    double pad_;
    uint depth_;
    BuildProgress &progress_;
};

std::vector<KdReference> kd_references(std::span<const Reference> references) {
    std::vector<KdReference> result(references.size());
    tbb::parallel_for(std::size_t(0), references.size(), [&](std::size_t i) {
        const Bounds &bounds = references[i].bounds;
        vec3 low = bounds.low;
        for (int axis = 0; axis < 3; ++axis)
            if (!(low[axis] < bounds.high[axis])) low[axis] = std::nextafter(low[axis], -INFINITY);
        result[i] = {low, uint(i), bounds.high};
    });
    return result;
}

/// Far below what a float can resolve of the scene.
double pad_for(const Bounds &box) {
    double extent = 1e-25;
    for (int axis = 0; axis < 3; ++axis) extent = std::max(extent, double(box.high[axis]) - box.low[axis]);
    return extent * 0x1p-40;
}

/// Havran's (thesis, section 4.5).
uint depth_for(std::size_t references) { return std::min(KD_DEPTH, uint(8 + 1.3 * std::log2(double(std::max<std::size_t>(references, 1))))); }

BuiltAccelerator build(std::span<const Reference> references, ChooseKdSplit choose, const char *name, BuildProgress &progress) {
    progress.begin(references.size());
    const Bounds box = bounds_of(references);
    Subtree tree;
    const KdBuild build(choose, pad_for(box), depth_for(references.size()), progress);
    build.build({kd_references(references), box, 0, copies_per_reference * double(references.size()), references.size()}, tree, 0);
    CellLists lists = list_cells(references, tree.leaves, name);
    for (KdNode &node : tree.nodes)
        if (node.word == KD_LEAF && node.plane != NO_ITEMS) node.plane = lists.lists[node.plane];
    return built_of_cells(KdTree{{}, box.low, box.high}, tree.nodes, std::move(lists));
}

}  // namespace

BuiltAccelerator build_kd_tree(std::span<const Reference> references, const Hulls &, BuildQuality, BuildProgress &progress) {
    return build(references, cheapest_split, "kd_tree", progress);
}
BuiltAccelerator build_kd_tree_median(std::span<const Reference> references, const Hulls &, BuildQuality, BuildProgress &progress) {
    return build(references, median_split, "kd_tree_median", progress);
}

}  // namespace brandung
