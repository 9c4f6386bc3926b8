// Sphere: the surface at a hit.
#pragma once
#include "kernels/core/load.cl"
#include "kernels/core/items.h"
#include "kernels/core/math.cl"
#include "kernels/core/scene.cl"
#include "kernels/core/spawn.cl"
#include "kernels/primitives/sphere.h"
#include "kernels/primitives/surface.h"

#define SPHERE(name) sphere_surface_##name
#include "kernels/primitives/sphere_offset.cl"
#undef SPHERE

FUNCTION SphereShading sphere_view(ShadingRecord record) {
    SphereShading sphere;
    sphere.center = load_floats(record.words);
    sphere.radius = as_float(record.words[3]);
    return sphere;
}

/// The point is put back onto the sphere, so that its error does not grow with the ray's length; the second time with twice the digits, so that
/// what is left is its own rounding, however large the sphere is.
FUNCTION Surface sphere_surface(Scene scene, ShadingRecord record, Ray ray, Hit hit) {
    const SphereShading sphere = sphere_view(record);
    const float radius = fabs(sphere.radius);
    Surface surface;
    surface.geometric = unit(plus(minus(ray.origin, sphere.center), scaled(ray.direction, hit.t)));
    surface.normal = surface.geometric;
    surface.lift = make3(0.0f, 0.0f, 0.0f);
    const vec3 p = plus(sphere.center, scaled(surface.geometric, radius));
    surface.p = minus(p, scaled(surface.geometric, sphere_surface_offset(sphere.center, radius, p) / (2.0f * radius)));
    // The difference's own rounding; and of the first point's error, 2^-21 of its terms, the correction leaves 2^-21, the offset's rounding less.
    const float bent = bend(surface.p, radius);
    surface.error = plus(scaled(absolute(surface.p), 0x1p-22f),
                         plus(scaled(plus(absolute(sphere.center), make3(radius, radius, radius)), 0x1p-38f), make3(bent, bent, bent)));
    return surface;
}

/// As a light: see emissive_sphere_sample, with the same decision whether `from` is outside.
FUNCTION float sphere_emission_factor(ShadingRecord record, vec3 from, vec3 p) {
    const SphereShading sphere = sphere_view(record);
    const float radius = fabs(sphere.radius);
    const vec3 f = minus(from, sphere.center), q = minus(p, sphere.center);
    const float square_d = dot3(f, f), offset = sphere_surface_offset(sphere.center, radius, from);
    const float z = dot3(f, q) / sqrt(square_d * dot3(q, q));
    return offset > 0.0f ? 4.0f * maximum(z, 0.0f) * (square_d / offset) : 1.0f;
}

/// The y axis leads to the pole at v = 1; u = 1/2 faces the z axis and grows towards the x axis.
FUNCTION Pattern sphere_pattern(Scene scene, ShadingRecord record, Ray ray, Hit hit) {
    const vec3 f = plus(minus(ray.origin, sphere_view(record).center), scaled(ray.direction, hit.t));
    Pattern pattern = {{0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}};
    pattern.uv.x = 0.5f + INVERSE_TWO_PI * arctangent(f.x, f.z);
    pattern.uv.y = 1.0f - 2.0f * INVERSE_TWO_PI * arctangent(sqrt(f.x * f.x + f.z * f.z), f.y);
    return pattern;
}
