// Products with weights in fixed point.
#pragma once
#include "kernels/core/portable.h"

/// value * weight, weight in units of 2^-30, to the nearest.
FUNCTION int64 weighed(int64 value, uint weight) {
    const uint64 magnitude = abs(value), rounding = 1ul << 29;
    const uint64 low = magnitude * weight, high = mul_hi(magnitude, (uint64)weight) + (low + rounding < low);
    const int64 result = (int64)(high << 34 | (low + rounding) >> 30);
    return value < 0l ? -result : result;
}
