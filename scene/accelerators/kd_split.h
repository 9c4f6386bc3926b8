/// Where a node of a kd-tree is cut.
#pragma once
#include <span>

#include "kernels/core/portable.h"
#include "scene/bounds.h"

namespace brandung {

/// A reference in a node. A box that is flat along an axis reaches a float below: so it has a part below a plane that it lies in, and none above.
struct KdReference {
    vec3 low;
    uint index;
    vec3 high;

    bool is_below(int axis, float plane) const { return low[axis] < plane; }
    bool is_above(int axis, float plane) const { return high[axis] > plane; }
};

/// A plane inside of a node, or none: the node is best left a leaf.
struct KdSplit {
    int axis = -1;
    float plane = 0;

    bool exists() const { return axis >= 0; }
};

/// `references` all have a part in the box. The same for any number of threads.
using ChooseKdSplit = KdSplit (*)(std::span<const KdReference> references, const Bounds &box, double pad);

/// The cheapest by the surface area heuristic (MacDonald and Booth, Heuristics for Ray Tracing Using Space Subdivision, The Visual Computer 6(3)
/// 1990). `pad`, above 0 and far below the scene's extent, keeps areas of flat boxes above 0.
KdSplit cheapest_split(std::span<const KdReference> references, const Bounds &box, double pad);

/// In the middle of the references, along the longest axis on which that separates any (the median cut of Kaplan, see kd_tree_walk.cl, by objects).
KdSplit median_split(std::span<const KdReference> references, const Bounds &box, double pad);

/// Expected cost of a leaf that a ray comes to, in steps from node to node.
double kd_leaf_cost(std::size_t references);

}  // namespace brandung
