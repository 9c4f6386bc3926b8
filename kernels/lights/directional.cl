// Directional light.
#pragma once
#include "kernels/core/lanes_1.cl"
#include "kernels/core/scene.cl"
#include "kernels/lights/directional.h"
#include "kernels/lights/light.h"
#include "kernels/lights/light_random.cl"

FUNCTION LightSample directional_sample(Scene scene, Light l, vec3 p, LightRandom random) {
    LightSample sample;
    sample.direction = sample.ray_direction = make3(as_float(l.words[0]), as_float(l.words[1]), as_float(l.words[2]));
    sample.distance = INFINITY;
    sample.irradiance = make3(as_float(l.words[3]), as_float(l.words[4]), as_float(l.words[5]));
    sample.inverse_density = 0.0f;
    return sample;
}
