// AOV: what surfaces reflect and let through.
#pragma once
#include "kernels/bsdfs/emitted.cl"
#include "kernels/bsdfs/scattering.cl"
#include "kernels/core/load.cl"
#include "kernels/core/scene.cl"

/// From 0 to 1: albedo and emission; where nothing is hit, the background.
FUNCTION vec3 aov_value(Scene scene, Ray ray, Hit hit, SurfacePoint point, Tints tint) {
    const global Material *material = SCENE_ARRAY(scene, Material, materials) + point.material;
    const Spectrum own = plus(bsdf_albedo(material, tint), emitted(material, point.flags));
    const Spectrum albedo = where((point.flags & SURFACE_HIT) != 0u, own, times(scene.header->background, tint.diffuse));
    return minimum(albedo, make3(1.0f, 1.0f, 1.0f));
}
#include "kernels/aovs/record_aov.cl"
