/// Disk; both sides are visible, the outside is where its normal leads.
#pragma once
#include "kernels/core/scene.h"

/// Points c + x, x ⊥ normal, with |x| <= radius.
typedef struct {
    uint primitive[BLOCK_SIZE];
    float center[3][BLOCK_SIZE], normal[3][BLOCK_SIZE];  ///< normal has unit length
    float radius[BLOCK_SIZE];                            ///< > 0
    float low[3][BLOCK_SIZE], high[3][BLOCK_SIZE];
} DiskBlock;

/// View of ShadingRecord.words.
typedef struct {
    vec3 center, normal;
    float radius;
} DiskShading;
