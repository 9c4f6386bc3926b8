/// Sphere: a negative radius shows the inside only.
#pragma once
#include "kernels/core/scene.h"

typedef struct {
    uint primitive[BLOCK_SIZE];
    float x[BLOCK_SIZE], y[BLOCK_SIZE], z[BLOCK_SIZE], radius[BLOCK_SIZE];
} SphereBlock;

/// View of ShadingRecord.words.
typedef struct {
    vec3 center;
    float radius;
} SphereShading;
