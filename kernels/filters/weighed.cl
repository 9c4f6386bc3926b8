// Products with weights in fixed point.
#pragma once
#include "kernels/core/integer128.cl"

/// value * weight, weight in units of 2^-30, to the nearest.
FUNCTION int64 weighed(int64 value, uint weight) {
    const Integer128 rounding = {1ul << 29, 0ul}, wide = plus(product((int64)abs(value), (int64)weight), rounding);
    const int64 result = (int64)(wide.high << 34 | wide.low >> 30);
    return value < 0l ? -result : result;
}
