/// Octree: a cube divided into eight wherever there is enough in it.
#pragma once
#include "kernels/accelerators/cells.h"

#define OCTREE_BITS 23u  ///< a side of the root is 2^OCTREE_BITS units
#define OCTREE_UNITS (1u << OCTREE_BITS)
#define OCTREE_DEPTH 18u         ///< of the smallest cells below the root, at most
#define OCTREE_LEAF 0x80000000u  ///< a child word with this bit is a leaf: the place of its list among the items; NO_ITEMS if it is empty

/// Child x + 2 y + 4 z has the upper half of the axes that are 1. All children of node 0 are the root itself.
typedef struct {
    uint child[8];  ///< a node's number or a leaf
} OctreeNode;

typedef struct {
    CellSpans spans;  ///< cells: the nodes
    vec3 low;         ///< corner of the root
    float unit;       ///< side of the root / OCTREE_UNITS
} Octree;
