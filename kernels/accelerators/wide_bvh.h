/// Bounding volume hierarchy with 8 children per node.
#pragma once
#include "kernels/core/portable.h"

#define BVH_WIDTH 8u
#define BVH_LEAF 0x80000000u   ///< a child word with this bit is a leaf: kind and block of its primitives
#define BVH_KIND_SHIFT 28u     ///< bits 28..30: the kind's number among those in use
#define BVH_BLOCK 0x0fffffffu  ///< bits 0..27: the block
#define BVH_EMPTY 0xffffffffu  ///< no child; its box is from +∞ to -∞, which no ray meets

/// Children that wait on the stack of a ray when it arrives at a node, at most; the builder sees to it.
#define BVH_PENDING 128u

/// Nodes on the way from the root to any other, both among them, at most: no fewer than a balanced tree over all primitives that there can be needs,
/// so that the builder can always see to it.
#define BVH_LEVELS 28u

/// 256 bytes. Children are sorted by the number of primitives below them, largest first, empty ones last.
typedef struct {
    float low[3][BVH_WIDTH], high[3][BVH_WIDTH];
    uint child[BVH_WIDTH];  ///< a node's index, a leaf's word or BVH_EMPTY
    uint spare[BVH_WIDTH];
} BvhNode;
