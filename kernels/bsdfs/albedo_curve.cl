// How much a rough surface reflects at once (kernels/bsdfs/albedo_curve.h).
#pragma once
#include "kernels/bsdfs/albedo_curve.h"
#include "kernels/core/lanes_1.cl"

FUNCTION AlbedoCurve albedo_curve(const global uint *words) {
    AlbedoCurve curve;
#pragma unroll
    for (int k = 0; k < ALBEDO_TERMS; ++k) curve.terms[k] = as_float(words[k]);
    return curve;
}

/// Of the curve, in [0, 1] (Clenshaw's recurrence).
FUNCTION float albedo_at(AlbedoCurve curve, float alpha, float cosine) {
    const float x = 2.0f * cosine * fma(2.0f, alpha, 1.0f) / fma(2.0f, alpha, cosine) - 1.0f;
    float b = 0.0f, before = 0.0f;
#pragma unroll
    for (int k = ALBEDO_TERMS - 1; k > 0; --k) {
        const float next = fma(2.0f * x, b, curve.terms[k] - before);
        before = b, b = next;
    }
    return minimum(maximum(fma(x, b, curve.terms[0] - before), 0.0f), 1.0f);
}
