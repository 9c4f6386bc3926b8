// AOV: where camera rays end.
#pragma once
#include "kernels/core/items.cl"
#include "kernels/core/load.cl"
#include "kernels/core/scene.cl"

/// In the world; infinity in x where nothing is hit.
FUNCTION vec3 aov_value(Scene scene, Ray ray, Hit hit, SurfacePoint point, Tints tint) {
    const bool is_hit = hit.primitive != NO_HIT;
    const vec3 position = plus(ray.origin, scaled(ray.direction, is_hit ? hit.t : 0.0f));
    return make3(is_hit ? position.x : INFINITY, position.y, position.z);
}
#include "kernels/aovs/record_aov.cl"
