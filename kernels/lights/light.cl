// Lights of all kinds in use.
#pragma once
#include "generated/lights.cl"
#include "kernels/core/items.cl"
#include "kernels/lights/light.h"

FUNCTION LightSample where(int c, LightSample a, LightSample b) {
    LightSample r;
    r.direction = where(c, a.direction, b.direction), r.distance = where(c, a.distance, b.distance);
    r.irradiance = where(c, a.irradiance, b.irradiance);
    return r;
}

/// Light from `light` at p.
FUNCTION LightSample light_sample(Light light, vec3 p) {
    LightSample sample = {{0.0f, 0.0f, 0.0f}, 0.0f, {0.0f, 0.0f, 0.0f}};
#define CASE(KIND, View, name) \
    ONLY_IF(light.kind == KIND) sample = where(light.kind == KIND, name##_sample(light, p), sample);
    FOR_EACH_LIGHT(CASE)
#undef CASE
    return sample;
}
