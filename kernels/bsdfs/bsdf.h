/// What the integrators ask of a BSDF; never stored.
#pragma once
#include "kernels/core/portable.h"

#define INVERSE_PI 0.318309886f

/// How an ideal interface divides the light: weights of the mirrored and of the refracted ray.
typedef struct {
    Spectrum reflected, refracted;
} Split;

/// Phong's model, as Whitted's integrator lights a surface with it.
typedef struct {
    Spectrum diffuse, specular;  ///< reflectances
    float exponent;              ///< of the highlight
} Phong;
