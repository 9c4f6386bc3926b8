// The surface and the material at one hit of a list, in an instance or outside of all; for loops that are not vectorised.
#pragma once
#include "generated/constants.h"
#include "generated/instances.cl"
#include "kernels/core/spawn.cl"
#include "kernels/primitives/primitive.cl"

FUNCTION Surface surface_of(Scene scene, Ray ray, PlacedHit hit) {
    const ShadingRecord record = SCENE_ARRAY(scene, ShadingRecord, shading)[hit.hit.primitive];
    const Ray inner = ray_in_group(scene, place_of(hit), ray);
    return surface_in_world(scene, place_of(hit), primitive_surface_serially(scene, record, inner, hit.hit));
}

/// Whether the ray cannot meet the same again further on.
FUNCTION bool is_flat(Scene scene, PlacedHit hit) {
    return (FLAT_KINDS >> SCENE_ARRAY(scene, ShadingRecord, shading)[hit.hit.primitive].kind & 1u) != 0u;
}

/// Whether the point of the one lies on the other, within the errors of both.
FUNCTION bool coincide(Surface a, Surface b) {
    const vec3 n = absolute(a.geometric);
    return fabs(dot3(a.geometric, minus(b.p, a.p))) <= dot3(n, plus(a.error, b.error));
}

/// The ray straight on from behind the surface that it has met, to the end that it had.
FUNCTION Ray ray_behind(Ray ray, PlacedHit met, Surface surface) {
    const vec3 onward = scaled(surface.geometric, dot3(surface.geometric, ray.direction) < 0.0f ? -1.0f : 1.0f);
    ray.origin = spawn_origin(surface.p, scaled(onward, dot3(absolute(onward), surface.error)));
    ray.t_max -= met.hit.t;
    ray.tag = RAY_TAG(RAY_KIND(ray.tag), met.hit.primitive);
    return ray;
}

FUNCTION uint material_index_of(Scene scene, PlacedHit hit) {
    return material_in_instance(scene, place_of(hit), SCENE_ARRAY(scene, ShadingRecord, shading)[hit.hit.primitive].material);
}
FUNCTION const global Material *material_of(Scene scene, PlacedHit hit) {
    return SCENE_ARRAY(scene, Material, materials) + material_index_of(scene, hit);
}
