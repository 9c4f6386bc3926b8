/// Whitted's surface: ambient, diffuse and highlight terms, ideal reflection and transmission.
#pragma once
#include "kernels/core/portable.h"

/// View of Material.words.
typedef struct {
    Spectrum ambient, diffuse, specular;  ///< reflectances
    Spectrum reflection, transmission;    ///< weights of the two secondary rays
    float exponent;                       ///< of the highlight
    uint fresnel;                         ///< 1: the two weights are scaled by Fresnel's reflectance and its complement
} Whitted;
