// Spot light.
#pragma once
#include "kernels/core/lanes_1.cl"
#include "kernels/core/scene.cl"
#include "kernels/lights/attenuation.cl"
#include "kernels/lights/light.h"
#include "kernels/lights/light_random.cl"
#include "kernels/lights/spot.h"

FUNCTION SpotLight spot_view(Light l) {
    SpotLight light;
    light.position = make3(as_float(l.words[0]), as_float(l.words[1]), as_float(l.words[2]));
    light.direction = make3(as_float(l.words[3]), as_float(l.words[4]), as_float(l.words[5]));
    light.intensity = make3(as_float(l.words[6]), as_float(l.words[7]), as_float(l.words[8]));
    light.attenuation = make3(as_float(l.words[9]), as_float(l.words[10]), as_float(l.words[11]));
    light.edge = as_float(l.words[12]), light.steepness = as_float(l.words[13]);
    return light;
}

/// The part of the intensity that goes towards -`direction`: Hermite's cubic of the cosine (Pharr et al., PBR 4ed, 12.2.1).
/// 1 - cos a = |u - v|² / 2 of unit vectors keeps its digits in narrow cones.
FUNCTION float spot_falloff(SpotLight light, vec3 direction) {
    const vec3 apart = plus(light.direction, direction);
    const float s = minimum(maximum((light.edge - 0.5f * dot3(apart, apart)) * light.steepness, 0.0f), 1.0f);
    return s * s * (3.0f - 2.0f * s);
}

FUNCTION LightSample spot_sample(Scene scene, Light l, vec3 p, LightRandom random) {
    const SpotLight light = spot_view(l);
    const vec3 way = minus(light.position, p);
    const float distance = sqrt(dot3(way, way));
    LightSample sample;
    sample.direction = sample.ray_direction = scaled(way, 1.0f / distance);
    sample.distance = distance;
    sample.irradiance = scaled(light.intensity, spot_falloff(light, sample.direction) / attenuation_at(light.attenuation, distance));
    sample.inverse_density = 0.0f;
    return sample;
}
