// Directional light.
#pragma once
#include "kernels/core/load.cl"
#include "kernels/core/scene.h"
#include "kernels/lights/directional.h"
#include "kernels/lights/light.h"

FUNCTION LightSample directional_sample(const global Light *l, vec3 p) {
    LightSample sample;
    sample.direction = load_floats(l->words);
    sample.distance = INFINITY;
    sample.irradiance = load_floats(l->words + 3);
    sample.pdf = 1.0f;
    return sample;
}
