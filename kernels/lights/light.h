/// What a light does to a point; never stored.
#pragma once
#include "kernels/core/portable.h"

typedef struct {
    vec3 direction;       ///< from the point towards the light, unit length
    float distance;       ///< to the light, infinite for directional ones
    Spectrum irradiance;  ///< on a surface at the point that faces the light [W/m²]
} LightSample;
