// The brightest that a sample may be.
#pragma once
#include "kernels/core/integer128.cl"

#define LARGEST_SAMPLE (1l << 48)  ///< 2^16

/// The channels of a sample, cut at ±2^16; whether one was beyond.
FUNCTION bool cut(const global Integer128 *sum, int64 *values) {
    bool too_bright = false;
    for (uint c = 0u; c < 3u; ++c) {
        values[c] = nearest_within(LARGEST_SAMPLE, sum[c]);
        too_bright |= !equal(sum[c], values[c]);
    }
    return too_bright;
}
