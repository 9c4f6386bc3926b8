// Functions of the angle at a rough surface (kernels/bsdfs/angle_curve.h).
#pragma once
#include "kernels/bsdfs/angle_curve.h"
#include "kernels/core/lanes_1.cl"

FUNCTION AngleCurve angle_curve(const global uint *words) {
    AngleCurve curve;
#pragma unroll
    for (int k = 0; k < CURVE_TERMS; ++k) curve.terms[k] = as_float(words[k]);
    return curve;
}

/// By Clenshaw's recurrence.
FUNCTION float value_at(AngleCurve curve, float alpha, float z) {
    const float s = alpha / fma(3.0f, alpha, 1.0f), x = 2.0f * z * (1.0f + s) / (z + s) - 1.0f;
    float b = 0.0f, before = 0.0f;
#pragma unroll
    for (int k = CURVE_TERMS - 1; k > 0; --k) {
        const float next = fma(2.0f * x, b, curve.terms[k] - before);
        before = b, b = next;
    }
    return fma(x, b, curve.terms[0] - before);
}
