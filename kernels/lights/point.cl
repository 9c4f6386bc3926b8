// Point light.
#pragma once
#include "kernels/core/load.cl"
#include "kernels/core/scene.h"
#include "kernels/lights/light.h"
#include "kernels/lights/point.h"

FUNCTION PointLight point_view(const global Light *l) {
    PointLight light;
    light.position = load_floats(l->words);
    light.intensity = load_floats(l->words + 3);
    light.attenuation = load_floats(l->words + 6);
    return light;
}

FUNCTION LightSample point_sample(const global Light *l, vec3 p) {
    const PointLight light = point_view(l);
    const vec3 way = minus(light.position, p);
    const float distance = sqrt(dot3(way, way));
    const float attenuation = fma(fma(light.attenuation.z, distance, light.attenuation.y), distance, light.attenuation.x);
    LightSample sample;
    sample.direction = scaled(way, 1.0f / distance);
    sample.distance = distance;
    sample.irradiance = scaled(light.intensity, 1.0f / attenuation);
    sample.pdf = 1.0f;
    return sample;
}
