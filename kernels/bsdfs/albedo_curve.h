/// The part of light that a rough surface reflects at once, by angle.
#pragma once
#include "kernels/core/portable.h"

#define ALBEDO_TERMS 9

/// Chebyshev's series in x = 2 μ (1 + 2 alpha) / (μ + 2 alpha) - 1 of that part over the reflectance of an ideal surface, μ being the cosine.
typedef struct {
    float terms[ALBEDO_TERMS];
} AlbedoCurve;
