// What samples weigh in pixels that a filter reaches from where they are.
#pragma once
#include "kernels/filters/filter.h"
#include "kernels/filters/splat.h"

/// f(x) / f(0) at a distance [pixels], linear between `values`, which are FILTER_INTERVALS + 1 from the centre to the radius.
FUNCTION float filter_value(float distance, float intervals, const global float *values) {
    const float x = fabs(distance) * intervals;
    if (x >= (float)(int)FILTER_INTERVALS) return 0.0f;
    const int i = (int)x;
    return fma(x - (float)i, values[i + 1] - values[i], values[i]);
}

/// Of a sample, by what it weighs in columns and in rows; in units of 1 / SPLAT_UNIT, rounded down.
FUNCTION uint splat_weight(float in_column, float in_row) { return (uint)(in_column * in_row * (float)(int)SPLAT_UNIT); }
