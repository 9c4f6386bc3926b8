/// Motions: transforms that change with time, in parts that are polynomials of it.
#pragma once
#include "kernels/primitives/transform.h"

#define MOTION_TERMS 4u

/// 448 bytes. Both transforms are polynomials in s, which goes from 0 to 1 within the part.
typedef struct {
    float begin;                       ///< the time where s is 0; the part before ends there
    float rate;                        ///< by which s grows with time
    Transform to_world[MOTION_TERMS];  ///< what 1, s, s², s³ are multiplied by
    Transform to_group[MOTION_TERMS];  ///< the same of what is nearly its inverse
    Transform mismatch;                ///< by how much a point comes back elsewhere from the world, at most: by magnitudes
    uint spare[2];
} MotionPart;
