/// Instances: groups of primitives that transforms place in the world.
#pragma once
#include "kernels/core/scene.h"
#include "kernels/primitives/transform.h"

/// 128 bytes. Number 0 is the world itself: primitives in it are in no instance.
typedef struct {
    Transform to_world;  ///< from the group's space
    Transform to_group;  ///< its inverse, rounded once
    uint group;          ///< entry of SceneHeader.groups
    uint material;       ///< that of all its primitives; NO_MATERIAL: they have their own
    uint first_part,
        parts;  ///< of its motion, entries of SceneHeader.motion_parts; none: it is at rest. Else the transforms are those of the first time
    uint spare[4];
} Instance;

typedef struct {
    uint primitive[BLOCK_SIZE];  ///< the instances' numbers
    float low[3][BLOCK_SIZE], high[3][BLOCK_SIZE];
} InstanceBlock;
