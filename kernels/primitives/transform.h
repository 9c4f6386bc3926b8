/// Affine maps.
#pragma once
#include "kernels/core/portable.h"

/// p -> x p.x + y p.y + z p.z + origin.
typedef struct {
    vec3 x, y, z, origin;
} Transform;
