/// Light from one direction, from infinitely far.
#pragma once
#include "kernels/core/portable.h"

/// View of Light.words.
typedef struct {
    vec3 direction;       ///< towards the light, unit length
    Spectrum irradiance;  ///< on a surface that faces it [W/m²]
} DirectionalLight;
