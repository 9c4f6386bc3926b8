// Light that paths meet at the ends of their rays.
#pragma once
#include "generated/constants.h"
#include "generated/instances.cl"
#include "kernels/bsdfs/emitted.cl"
#include "kernels/core/items.h"
#include "kernels/core/scene.cl"
#include "kernels/integrators/power_heuristic.cl"
#include "kernels/lights/choice.cl"

/// The weight of the background where a ray that has met nothing was chosen with density `pdf` by a surface that has asked for light.
FUNCTION float background_weight(Scene scene, bool is_weighted, float pdf, vec3 wo) {
    return is_weighted ? power_heuristic(environment_density(scene, negate(wo)) / pdf) : 1.0f;
}

/// What of the background a ray brings that has met nothing, weighted as met_light is.
FUNCTION Spectrum met_background(Scene scene, bool is_weighted, float pdf, vec3 wo, Tints tint) {
    return scaled(times(scene.header->background, tint.diffuse), background_weight(scene, is_weighted, pdf, wo));
}

/// The weight of what shines with `radiance` where a ray has met a surface: against the light that its origin has asked, where the surface there
/// chose the ray's direction with density `pdf`.
FUNCTION float met_weight(Scene scene, bool is_weighted, Spectrum radiance, Ray ray, float pdf, Placement place, SurfacePoint surface,
                          SurfaceInterface interface, vec3 wo) {
    if (!is_weighted) return 1.0f;
    const ShadingRecord record = SCENE_ARRAY(scene, ShadingRecord, shading)[SURFACE_PRIMITIVE(surface.flags)];
    // Where it was met but for rounding: surface.origin may be lifted off its face, from which light is asked.
    const vec3 straight = minus(interface.beyond, ray.origin);
    const float density = emission_density(scene, record, place, radiance, ray.origin, interface.beyond, interface.geometric,
                                           sqrt(dot3(straight, straight)), dot3(interface.geometric, wo));
    return power_heuristic(density / pdf);
}

/// What a ray brings of what shines where it has met a surface.
FUNCTION Spectrum met_light(Scene scene, bool is_weighted, Ray ray, float pdf, Placement place, SurfacePoint surface, SurfaceInterface interface,
                            vec3 wo) {
    const Spectrum radiance = emitted(SCENE_ARRAY(scene, Material, materials) + surface.material, surface.flags);
    return scaled(radiance, met_weight(scene, is_weighted, radiance, ray, pdf, place, surface, interface, wo));
}
