// The cells of the picture all around.
#pragma once
#include "kernels/core/scene.cl"
#include "kernels/lights/environment.h"

/// Where a row's cells begin, and the last one ends.
FUNCTION const global float *environment_row_begins(Scene scene, uint row, uint columns) {
    return SCENE_ARRAY(scene, float, environment_begins) + row * ENVIRONMENT_STRIDE(columns);
}
