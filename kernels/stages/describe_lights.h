/// What is told of a light that a surface does not ask whether it is visible.
#pragma once
#include "kernels/core/portable.h"

/// 20 bytes.
typedef struct {
    Spectrum irradiance;  ///< on a surface there that faces it
    float cosine;         ///< between the shading normal and the way to it
    uint refusals;        ///< LIGHT_...: all that speak against it
} LightDescription;
