// Pinhole camera.
#pragma once
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/params.h"

/// The ray through picture point (x, y) in [0, 1]², from the top left.
FUNCTION Ray camera_ray(Camera camera, float x, float y) {
    Ray ray;
    ray.origin = camera.position;
    ray.direction = unit(plus(camera.corner, plus(scaled(camera.right, x), scaled(camera.down, y))));
    ray.t_max = INFINITY;
    ray.tag = RAY_TAG(RAY_CAMERA, NO_HIT);
    return ray;
}
