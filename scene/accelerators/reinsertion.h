/// Better binary hierarchies: subtrees move to where they enlarge others less.
#pragma once
#include "scene/accelerators/bvh2.h"

namespace brandung {

inline constexpr uint reinsertion_rounds = 4;

/// Lessens the sum of the areas of all nodes by taking subtrees out and putting them back elsewhere, many at once: after Meister and Bittner,
/// Parallel Reinsertion for Bounding Volume Hierarchy Optimization (Computer Graphics Forum 37(2), 2018). What fits a block stays together. No leaf
/// comes to lie deeper than `depth_limit` below the root, unless it was. Nodes come to be in an order that does not depend on the number of threads;
/// a node's references are then those of the leaves below it, and no range. Counts every reference reinsertion_rounds times as progress.
void reinsert(Bvh2 &tree, uint depth_limit, BuildProgress &progress);

}  // namespace brandung
