/// The binary hierarchy from which a wide one is made.
#pragma once
#include <memory>
#include <span>

#include "scene/accelerators/kind_box.h"
#include "scene/accelerators/large_array.h"

namespace brandung {

struct Bvh2Node {
    KindBox box;        ///< exact union of the boxes of its references
    uint first, count;  ///< its references: a range of Bvh2::references, above leaves only until reinsert() moves some
    uint children;      ///< index of the first of two adjacent nodes; 0: none, a leaf

    /// Its references may be one block.
    bool fits_block() const { return count <= BLOCK_SIZE && box.one_kind(); }
};

/// The tree is the same for any number of threads, only the places of its nodes are not.
struct Bvh2 {
    LargeArray<SortedReference> references;
    LargeArray<Bvh2Node> nodes;  ///< the root first; as built, parents before their children
    uint node_count = 0;
    RelativeArea area_of;

    float area(const Bvh2Node &node) const { return area_of(node.box); }
};

struct Bvh2Options {
    uint slack;  ///< leaves are at most depth_limit(references, slack) below the root; 0 gives a balanced tree
    /// Of what fits a block, ranges of so many references and more are offered in pieces as well, for the collapse to choose from; above
    /// BLOCK_SIZE none is.
    uint smallest_divided = BLOCK_SIZE + 1;
};
/// Levels below the root: those of a balanced tree over so many references, and `slack` more.
uint depth_limit(size_t references, uint slack);

/// Parallel build by binned SAH. All leaves fit a block; so may some nodes above leaves. Counts every reference once as progress, which its user
/// begins. There must be a reference.
Bvh2 build_bvh2(std::span<const Reference> references, const Bvh2Options &options, BuildProgress &progress);

}  // namespace brandung
