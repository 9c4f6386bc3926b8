// Surfaces of all kinds of primitives in use.
#pragma once
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/scene.cl"
#include "kernels/primitives/surface.h"
#include "generated/primitive_surfaces.cl"
#include "generated/primitives.cl"

FUNCTION Surface where(int c, Surface a, Surface b) {
    Surface r;
    r.p = where(c, a.p, b.p);
    r.error = where(c, a.error, b.error);
    r.geometric = where(c, a.geometric, b.geometric);
    r.normal = where(c, a.normal, b.normal);
    r.lift = where(c, a.lift, b.lift);
    return r;
}

/// Where one ray met the primitive that `record` describes; for loops that are not vectorised.
FUNCTION Surface primitive_surface_serially(Scene scene, ShadingRecord record, Ray ray, Hit hit) {
    Surface surface;
#define CASE(KIND, Record, name) \
    if (record.kind == KIND) surface = name##_surface(scene, record, ray, hit);
    FOR_EACH_PRIMITIVE(CASE)
#undef CASE
    return surface;
}

/// Colours there, serially too.
FUNCTION Pattern primitive_pattern(Scene scene, ShadingRecord record, Ray ray, Hit hit) {
    Pattern pattern;
#define CASE(KIND, Record, name) \
    if (record.kind == KIND) pattern = name##_pattern(scene, record, ray, hit);
    FOR_EACH_PRIMITIVE(CASE)
#undef CASE
    return pattern;
}

/// How dense points of the primitive as a light are round p, as seen from `from`, over their mean density by area; both in its own space.
FUNCTION float primitive_emission_factor(ShadingRecord record, vec3 from, vec3 p) {
    float factor = 1.0f;
#define CASE(KIND, Record, name) \
    ONLY_IF(record.kind == KIND) factor = record.kind == KIND ? name##_emission_factor(record, from, p) : factor;
    FOR_EACH_PRIMITIVE(CASE)
#undef CASE
    return factor;
}

/// Where the ray met the primitive that `record` describes.
FUNCTION Surface primitive_surface(Scene scene, ShadingRecord record, Ray ray, Hit hit) {
    Surface surface;
    surface.p = ray.origin, surface.error = make3(0.0f, 0.0f, 0.0f);
    surface.geometric = negate(ray.direction), surface.normal = surface.geometric, surface.lift = surface.error;
#define CASE(KIND, Record, name) \
    ONLY_IF(record.kind == KIND) surface = where(record.kind == KIND, name##_surface(scene, record, ray, hit), surface);
    FOR_EACH_PRIMITIVE(CASE)
#undef CASE
    return surface;
}
