// Functions of the angle at a rough surface (kernels/bsdfs/angle_curve.h).
#pragma once
#include "kernels/bsdfs/angle_curve.h"
#include "kernels/core/lanes_1.cl"

/// Of the curve in these words, by Clenshaw's recurrence. From memory term by term: a private array would keep loops over items from vectorising.
FUNCTION float value_at(const global uint *curve, float alpha, float z) {
    const float s = alpha / fma(3.0f, alpha, 1.0f), x = 2.0f * z * (1.0f + s) / (z + s) - 1.0f;
    float b = 0.0f, before = 0.0f;
#pragma unroll
    for (int k = CURVE_TERMS - 1; k > 0; --k) {
        const float next = fma(2.0f * x, b, as_float(curve[k]) - before);
        before = b, b = next;
    }
    return fma(x, b, as_float(curve[0]) - before);
}
