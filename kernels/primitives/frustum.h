/// Lateral surface of a cone frustum or cylinder, without caps.
#pragma once
#include "kernels/core/scene.h"

/// Points c + z axis + x, x ⊥ axis, with |z| <= half_length and |x| = radius + slope z.
typedef struct {
    uint primitive[BLOCK_SIZE];
    float center[3][BLOCK_SIZE], axis[3][BLOCK_SIZE];  ///< axis has unit length
    float half_length[BLOCK_SIZE];
    float radius[BLOCK_SIZE];  ///< half way, > 0
    float slope[BLOCK_SIZE];
    float side[BLOCK_SIZE];  ///< 1, or -1 if only the inside is visible
    float low[3][BLOCK_SIZE], high[3][BLOCK_SIZE];
} FrustumBlock;

/// View of ShadingRecord.words.
typedef struct {
    vec3 center, axis;
    float radius, slope, half_length;
} FrustumShading;
