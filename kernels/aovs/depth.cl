// AOV: distances along camera rays.
#pragma once
#include "kernels/core/items.cl"
#include "kernels/core/load.cl"
#include "kernels/core/scene.cl"

/// In x; infinity where nothing is hit.
FUNCTION vec3 aov_value(Scene scene, Ray ray, Hit hit, SurfacePoint point, Tints tint) {
    return make3(hit.primitive != NO_HIT ? hit.t * sqrt(dot3(ray.direction, ray.direction)) : INFINITY, 0.0f, 0.0f);
}
#include "kernels/aovs/record_aov.cl"
