/// A function of the angle at a rough surface.
#pragma once
#include "kernels/core/portable.h"

#define CURVE_TERMS 9

/// Chebyshev's series in x = 2 z (1 + s) / (z + s) - 1, from -1 to 1, of the angle's cosine z; s = alpha / (1 + 3 alpha): shadows fall where z is
/// about alpha.
typedef struct {
    float terms[CURVE_TERMS];
} AngleCurve;
