// The surface and the material at one hit of a list, in an instance or outside of all; for loops that are not vectorised.
#pragma once
#include "generated/instances.cl"
#include "kernels/primitives/primitive.cl"

FUNCTION Surface surface_of(Scene scene, Ray ray, PlacedHit hit) {
    const global ShadingRecord *record = SCENE_ARRAY(scene, ShadingRecord, shading) + hit.hit.primitive;
    const Ray inner = ray_in_group(scene, instance_of(hit), ray);
    return surface_in_world(scene, instance_of(hit), primitive_surface_serially(scene, record, inner, hit.hit));
}

FUNCTION uint material_index_of(Scene scene, PlacedHit hit) {
    return material_in_instance(scene, instance_of(hit), SCENE_ARRAY(scene, ShadingRecord, shading)[hit.hit.primitive].material);
}
FUNCTION const global Material *material_of(Scene scene, PlacedHit hit) {
    return SCENE_ARRAY(scene, Material, materials) + material_index_of(scene, hit);
}
