// Lights of all kinds in use.
#pragma once
#include "generated/instances.cl"
#include "generated/lights.cl"
#include "kernels/core/items.cl"
#include "kernels/lights/light.h"
#include "kernels/lights/light_random.cl"

FUNCTION LightSample where(int c, LightSample a, LightSample b) {
    LightSample r;
    r.direction = where(c, a.direction, b.direction), r.ray_direction = where(c, a.ray_direction, b.ray_direction);
    r.distance = where(c, a.distance, b.distance), r.irradiance = where(c, a.irradiance, b.irradiance);
    r.inverse_density = where(c, a.inverse_density, b.inverse_density);
    return r;
}

/// Light from `light` at p, of emissive shapes from a point that `random` chooses.
FUNCTION LightSample light_sample(Scene scene, Light light, vec3 p, LightRandom random) {
    LightSample sample = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, 0.0f, {0.0f, 0.0f, 0.0f}, 0.0f};
#define CASE(KIND, View, name) \
    ONLY_IF(light.kind == KIND) sample = where(light.kind == KIND, name##_sample(scene, light, p, random), sample);
    FOR_EACH_LIGHT(CASE)
#undef CASE
    return sample;
}

/// The same for the ray with this branch, for each light other numbers, and at the time of what is lit there.
FUNCTION LightSample light_sample(Scene scene, Light light, vec3 p, uint branch, Placement lit) {
    LightRandom random = light_random(light, branch);
    SET_TIME(random, lit.time);
    return light_sample(scene, light, p, random);
}

/// All that speaks against asking whether the light is visible: LIGHT_...; 0 where it may add something.
FUNCTION uint light_refusals(SurfacePoint surface, LightSample sample) {
    const uint shown = (surface.flags & SURFACE_LIT) != 0u ? 0u : LIGHT_NOT_SHOWN;
    const uint faces = dot3(surface.normal, sample.direction) > 0.0f ? 0u : LIGHT_BEHIND;
    return shown | faces | (largest(sample.irradiance) > 0.0f ? 0u : LIGHT_SENDS_NOTHING);
}
