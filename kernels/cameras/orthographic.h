/// Parallel rays.
#pragma once
#include "kernels/core/portable.h"

/// View of Camera.words. The ray through picture point (x, y) in [0, 1]², from the top left, begins at position + corner + x right + y down.
typedef struct {
    vec3 corner, right, down;
    vec3 direction;  ///< of all rays, unit length
} Orthographic;
