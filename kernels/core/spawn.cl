// Where rays that leave a surface begin and end: beyond the error of the point, so that they never meet their own surface and need no epsilon.
#pragma once
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/math.cl"

/// How far a surface of this radius of curvature bends away from its tangent plane where a ray begins that leaves p: rounding moves it to the side by
/// up to 1.5 ulp of each of two coordinates, at most 2^-22 of the largest one, and by half its square over the radius.
FUNCTION float bend(vec3 p, float radius) {
    const float aside = 0x1p-22f * largest(absolute(p));
    return aside * aside / maximum(maximum(radius, aside), 0x1p-126f);
}

FUNCTION Ray where(int c, Ray a, Ray b) {
    Ray r;
    r.origin = where(c, a.origin, b.origin), r.direction = where(c, a.direction, b.direction);
    r.t_max = c ? a.t_max : b.t_max, r.tag = c ? a.tag : b.tag;
    return r;
}

FUNCTION float away(float value, float direction) {
    const float up = next_up(value), down = next_down(value);
    return direction > 0.0f ? up : direction < 0.0f ? down : value;
}

/// The point moved by `offset`, a normal as long as the point's error bound, and rounded away from the surface (Pharr et al., PBR 4ed, 6.8.6).
FUNCTION vec3 spawn_origin(vec3 p, vec3 offset) {
    return make3(away(p.x + offset.x, offset.x), away(p.y + offset.y, offset.y), away(p.z + offset.z, offset.z));
}

/// A ray that leaves a primitive, from an origin that spawn_origin has made.
FUNCTION Ray ray_spawn(vec3 origin, vec3 direction, uint kind, uint primitive) {
    Ray ray;
    ray.origin = origin;
    ray.direction = direction;
    ray.t_max = INFINITY;
    ray.tag = RAY_TAG(kind, primitive);
    return ray;
}

/// From such an origin to a light that lies `distance` away; ends before it by more than the rounding of both ends.
FUNCTION Ray ray_to_light(vec3 origin, vec3 direction, float distance, uint primitive) {
    const float rounding = 0x1p-21f * (distance + largest(absolute(origin)));
    Ray ray = ray_spawn(origin, direction, RAY_SHADOW, primitive);
    ray.t_max = distance < INFINITY ? maximum(distance - rounding, 0.0f) : INFINITY;
    return ray;
}
