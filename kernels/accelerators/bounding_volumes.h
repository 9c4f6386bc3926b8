/// Hierarchy of bounding volumes: each node has its box, and where that saves work a tighter volume inside it.
#pragma once
#include "kernels/core/portable.h"

#define VOLUME_LEAF 0x80000000u   ///< VolumeNode.children with this bit is a leaf: kind and block of its primitives
#define VOLUME_KIND_SHIFT 28u     ///< bits 28..30: the kind's number among those in use
#define VOLUME_BLOCK 0x0fffffffu  ///< bits 0..27: the block
#define VOLUME_STACK 64u          ///< nodes that wait, at most

#define VOLUME_NONE 0u          ///< the box alone
#define VOLUME_SPHERE 1u        ///< center, radius
#define VOLUME_ELLIPSOID 2u     ///< center, rows of the map that makes it a unit sphere, largest stretch of that map
#define VOLUME_ORIENTED_BOX 3u  ///< center, three axes, half of the extents along them
#define VOLUME_DIAGONALS 4u  ///< lowest and highest p·n for n = (1, 1, 1), (1, 1, -1), (1, -1, 1), (-1, 1, 1): with the box a polytope of 14 sides
#define VOLUME_KINDS 5u
#define VOLUME_PLACE_SHIFT 3u  ///< VolumeNode.volume: kind, and above these bits the place among the volumes

/// 32 bytes.
typedef struct {
    vec3 low, high;
    uint children;  ///< the first of two adjacent nodes, or a leaf
    uint volume;
} VolumeNode;

typedef struct {
    float words[16];
} Volume;

/// Begins what is in the arena: the nodes follow, of which the first is the root, and then the volumes.
typedef struct {
    uint node_count;  ///< 0: there is nothing
    uint spare[7];
} VolumeTree;
