// Frustum: the surface at a hit.
#pragma once
#include "kernels/core/load.cl"
#include "kernels/core/items.h"
#include "kernels/core/math.cl"
#include "kernels/core/scene.cl"
#include "kernels/core/spawn.cl"
#include "kernels/primitives/azimuth.cl"
#include "kernels/primitives/frustum.h"
#include "kernels/primitives/surface.h"

FUNCTION FrustumShading frustum_view(ShadingRecord record) {
    FrustumShading frustum;
    frustum.center = load_floats(record.words);
    frustum.axis = load_floats(record.words + 3);
    frustum.radius = as_float(record.words[6]);
    frustum.slope = as_float(record.words[7]);
    frustum.half_length = as_float(record.words[8]);
    return frustum;
}

/// Points of it as a light are uniform by area.
FUNCTION float frustum_emission_factor(ShadingRecord record, vec3 from, vec3 p) { return 1.0f; }

/// The point is put back onto the surface, so that its error does not grow with the ray's length: between the ends too, since beyond a tip is none.
/// Near the axis the way outward is what rounding leaves of f; made perpendicular once more, it is so to the last digits. Where it leaves nothing, at
/// the tip or seen from so far that all of the frustum is one place, any way outward will do.
FUNCTION Surface frustum_surface(Scene scene, ShadingRecord record, Ray ray, Hit hit) {
    const FrustumShading frustum = frustum_view(record);
    const vec3 f = plus(minus(ray.origin, frustum.center), scaled(ray.direction, hit.t));
    const float z = dot3(f, frustum.axis);
    const vec3 rough = minus(f, scaled(frustum.axis, z)), x = minus(rough, scaled(frustum.axis, dot3(rough, frustum.axis)));
    const vec3 outward = unit(where(dot3(x, x) > 0.0f, x, across_axis(frustum.axis)));
    const float place = minimum(maximum(z, -frustum.half_length), frustum.half_length);
    const float radius = maximum(fma(frustum.slope, place, frustum.radius), 0.0f);
    Surface surface;
    surface.p = plus(frustum.center, plus(scaled(frustum.axis, place), scaled(outward, radius)));
    const float size = fabs(place) + radius;
    const float bent = bend(surface.p, radius);
    surface.error = plus(scaled(plus(absolute(frustum.center), make3(size, size, size)), 0x1p-21f), make3(bent, bent, bent));
    surface.geometric = unit(minus(outward, scaled(frustum.axis, frustum.slope)));
    surface.normal = surface.geometric;
    surface.lift = make3(0.0f, 0.0f, 0.0f);
    return surface;
}

/// v grows from the base, 0, to the apex, 1; u runs around the axis, counterclockwise as seen from the apex.
FUNCTION Pattern frustum_pattern(Scene scene, ShadingRecord record, Ray ray, Hit hit) {
    const FrustumShading frustum = frustum_view(record);
    const vec3 f = plus(minus(ray.origin, frustum.center), scaled(ray.direction, hit.t)), axis = frustum.axis;
    Pattern pattern = {{0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}};
    pattern.uv.x = azimuth(axis, f);
    pattern.uv.y = 0.5f + 0.5f * dot3(f, axis) / frustum.half_length;
    return pattern;
}
