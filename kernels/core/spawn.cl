// Where rays that leave a surface begin and end: beyond the error of the point, so that they never meet their own surface and need no epsilon.
#pragma once
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/math.cl"

FUNCTION float away(float value, float direction) {
    const float up = next_up(value), down = next_down(value);
    return direction > 0.0f ? up : direction < 0.0f ? down : value;
}

/// The point moved by its error bound, side 1: to the side of `wo`, -1: beyond; rounded away from the surface (Pharr et al., PBR 4ed, 6.8.6).
FUNCTION vec3 origin_on_side(SurfacePoint surface, float side) {
    const vec3 offset = scaled(surface.offset, side);
    return make3(away(surface.p.x + offset.x, offset.x), away(surface.p.y + offset.y, offset.y), away(surface.p.z + offset.z, offset.z));
}

/// The origin of a ray that leaves in `direction`.
FUNCTION vec3 spawn_origin(SurfacePoint surface, vec3 direction) {
    return origin_on_side(surface, dot3(surface.offset, direction) < 0.0f ? -1.0f : 1.0f);
}

/// 1 if light falls on the side of `wo`, -1 if beyond.
FUNCTION float lit_side(SurfacePoint surface) { return (surface.flags & SURFACE_LIT_BEYOND) != 0u ? -1.0f : 1.0f; }

FUNCTION Ray ray_spawn(SurfacePoint surface, vec3 direction, uint kind) {
    Ray ray;
    ray.origin = spawn_origin(surface, direction);
    ray.direction = direction;
    ray.t_max = INFINITY;
    ray.kind = kind;
    return ray;
}

/// From a surface towards a light that lies `distance` away in `direction`; ends before it by more than the rounding of both ends.
FUNCTION Ray ray_to_light(vec3 origin, vec3 direction, float distance) {
    Ray ray;
    ray.origin = origin;
    ray.direction = direction;
    const float rounding = 0x1p-21f * (distance + largest(absolute(origin)));
    ray.t_max = distance < INFINITY ? maximum(distance - rounding, 0.0f) : INFINITY;
    ray.kind = RAY_SHADOW;
    return ray;
}
