// AOV: shading normals.
#pragma once
#include "kernels/core/load.cl"
#include "kernels/core/scene.cl"
#include "kernels/core/items.cl"

/// In the world, on the side of the surface that the eye sees, unit length; 0 where nothing is hit.
FUNCTION vec3 aov_value(Scene scene, Ray ray, Hit hit, SurfacePoint point, Tints tint) {
    const float lit_side = (point.flags & SURFACE_LIT_BEYOND) != 0u ? -1.0f : 1.0f, side = (point.flags & SURFACE_HIT) != 0u ? lit_side : 0.0f;
    return where(side != 0.0f, scaled(point.normal, side), make3(0.0f, 0.0f, 0.0f));
}
#include "kernels/aovs/record_aov.cl"
