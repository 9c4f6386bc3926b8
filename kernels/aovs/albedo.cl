// AOV: what surfaces reflect and let through.
#pragma once
#include "generated/bsdfs.cl"
#include "kernels/bsdfs/emitted.cl"
#include "kernels/core/items.cl"
#include "kernels/core/load.cl"
#include "kernels/core/scene.cl"

/// About the part of light that is reflected or let through.
FUNCTION Spectrum bsdf_albedo(const global Material *m, Tints tint) {
    Spectrum result = make3(0.0f, 0.0f, 0.0f);
#define CASE(KIND, View, name) \
    ONLY_IF(m->kind == KIND) result = where(m->kind == KIND, name##_albedo(m, tint), result);
    FOR_EACH_BSDF(CASE)
#undef CASE
    return result;
}

/// From 0 to 1: albedo and emission; where nothing is hit, the background.
FUNCTION vec3 aov_value(Scene scene, Ray ray, Hit hit, SurfacePoint point, Tints tint) {
    const global Material *material = SCENE_ARRAY(scene, Material, materials) + point.material;
    const Spectrum own = plus(bsdf_albedo(material, tint), emitted(material, point.flags));
    const Spectrum albedo = where((point.flags & SURFACE_HIT) != 0u, own, times(scene.header->background, tint.diffuse));
    return minimum(albedo, make3(1.0f, 1.0f, 1.0f));
}
#include "kernels/aovs/record_aov.cl"
