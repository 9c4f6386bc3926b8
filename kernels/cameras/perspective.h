/// Pinhole camera.
#pragma once
#include "kernels/core/portable.h"

/// View of Camera.words. The ray through picture point (x, y) in [0, 1]², from the top left, has direction corner + x right + y down.
typedef struct {
    vec3 corner, right, down;
} Perspective;
