/// Kd-tree: a box halved by planes that stand on the axes, the halves again, and so on (a BSP tree of such planes).
#pragma once
#include "kernels/accelerators/cells.h"

/// 8 bytes. The root is node 0, node 1 is none. Children follow each other, at an even number, the one below the plane first.
typedef struct {
    uint plane;  ///< bits of the float; a leaf's: place of its list among the items, or NO_ITEMS
    uint word;   ///< bits 0..1: the axis that the plane stands on, or KD_LEAF; above: number of the child below the plane
} KdNode;

#define KD_AXIS 3u
#define KD_LEAF 3u
#define KD_CHILD_SHIFT 2u
#define KD_NODES (1u << 30)  ///< no tree has more
#define KD_DEPTH 48u         ///< planes above a leaf, at most

typedef struct {
    CellSpans spans;  ///< cells: the nodes
    vec3 low, high;   ///< of the root's box
} KdTree;
