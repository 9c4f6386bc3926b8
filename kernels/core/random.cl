// Random numbers: functions of (seed, pixel, sample, dimension), never of a lane or of the time.
#pragma once
#include "kernels/core/portable.h"

/// Mixes all bits (lowbias32 by Wellons, 2018).
FUNCTION uint hash(uint x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ (x >> 16);
}
/// In [0, 1): the upper 24 bits, never 1.
FUNCTION float unit_interval(uint x) { return (float)(int)(x >> 8) * 0x1p-24f; }
