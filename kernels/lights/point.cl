// Point light.
#pragma once
#include "kernels/core/lanes_1.cl"
#include "kernels/core/scene.cl"
#include "kernels/lights/attenuation.cl"
#include "kernels/lights/light.h"
#include "kernels/lights/light_random.cl"
#include "kernels/lights/point.h"

FUNCTION PointLight point_view(Light l) {
    PointLight light;
    light.position = make3(as_float(l.words[0]), as_float(l.words[1]), as_float(l.words[2]));
    light.intensity = make3(as_float(l.words[3]), as_float(l.words[4]), as_float(l.words[5]));
    light.attenuation = make3(as_float(l.words[6]), as_float(l.words[7]), as_float(l.words[8]));
    return light;
}

FUNCTION LightSample point_sample(Scene scene, Light l, vec3 p, LightRandom random) {
    const PointLight light = point_view(l);
    const vec3 way = minus(light.position, p);
    const float distance = sqrt(dot3(way, way));
    LightSample sample;
    sample.direction = sample.ray_direction = scaled(way, 1.0f / distance);
    sample.distance = distance;
    sample.irradiance = scaled(light.intensity, 1.0f / attenuation_at(light.attenuation, distance));
    sample.inverse_density = 0.0f;
    return sample;
}
