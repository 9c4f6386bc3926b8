/// Which nodes of a binary hierarchy become nodes with 8 children.
#pragma once
#include <memory>

#include "kernels/accelerators/wide_bvh.h"
#include "scene/accelerators/bvh2.h"

namespace brandung {

/// How to cut the binary tree into wide nodes at the least expected cost of a ray, a node and a block costing the same: Ylitie, Karras, Laine,
/// Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs (HPG 2017), section 3.1. It has fewer nodes than opening the
/// largest child until there are 8, and rays need fewer steps.
struct Cut {
    std::array<float, BVH_WIDTH> cost;          ///< [j]: of the subtree as up to j children of one wide node; j > 0
    std::array<uint8_t, BVH_WIDTH + 1> shares;  ///< [j]: so many of the j go to the first binary child; 0: the subtree is one child
    bool is_leaf;                               ///< as one child it is a block, not a node
};

/// Those of all nodes, by their place. Parallel.
LargeArray<Cut> cut_tree(const Bvh2 &tree);

}  // namespace brandung
