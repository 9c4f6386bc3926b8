// Products with weights in fixed point.
#pragma once
#include "kernels/core/portable.h"

/// value * weight, value below 2^62, weight in units of 2^-30, to the nearest.
FUNCTION uint64 weighed(uint64 value, uint weight) {
    const uint64 low = value & ((1ul << 30) - 1ul), high = (uint)(value >> 30);
    return high * weight + ((low * weight + (1ul << 29)) >> 30);
}

FUNCTION int64 weighed(int64 value, uint weight) {
    const int64 magnitude = (int64)weighed((uint64)abs(value), weight);
    return value < 0l ? -magnitude : magnitude;
}
