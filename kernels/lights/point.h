/// Point light.
#pragma once
#include "kernels/core/portable.h"

/// View of Light.words. At distance d it gives intensity / (attenuation.x + attenuation.y d + attenuation.z d²).
typedef struct {
    vec3 position;
    Spectrum intensity;  ///< [W/sr]
    vec3 attenuation;
} PointLight;
