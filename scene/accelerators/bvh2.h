/// The binary hierarchy from which a wide one is made.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "scene/accelerators/kind_box.h"

namespace brandung {

struct Bvh2Node {
    KindBox box;        ///< exact union of the boxes of its references
    uint first, count;  ///< its references, a range of Bvh2::references
    uint children;      ///< index of the first of two adjacent nodes; 0: none, a leaf

    /// Its references may be one block.
    bool fits_block() const { return count <= BLOCK_SIZE && box.one_kind(); }
};

/// The tree is the same for any number of threads, only the places of its nodes are not.
struct Bvh2 {
    std::vector<SortedReference> references;
    std::unique_ptr<Bvh2Node[]> nodes;  ///< the root first; parents before their children
    uint node_count = 0;
    double pad = 0;  ///< for KindBox::half_area

    double area(const Bvh2Node &node) const { return node.box.half_area(pad); }
};

/// Parallel build by binned SAH. All leaves fit a block; so do some nodes above leaves, for the collapse to choose from.
/// Counts every reference once as progress, which its user begins.
/// Leaves are at most ceil(log2(size of references)) + `slack` below the root: 0 gives a balanced tree. There must be a reference.
Bvh2 build_bvh2(std::span<const Reference> references, uint slack, BuildProgress &progress);

}  // namespace brandung
