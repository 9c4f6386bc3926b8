// Order among 8 lanes.
#pragma once
#include "kernels/core/portable.h"

#define EXCHANGE(partner, lower...)                        \
    {                                                      \
        const int8 other = v.partner;                      \
        v = (int8)(lower) ? min(v, other) : max(v, other); \
    }
/// Largest first (Batcher's bitonic sort, AFIPS SJCC 1968).
FUNCTION int8 sorted(int8 v) {
    EXCHANGE(s10325476, 0, -1, -1, 0, 0, -1, -1, 0)
    EXCHANGE(s23016745, 0, 0, -1, -1, -1, -1, 0, 0)
    EXCHANGE(s10325476, 0, -1, 0, -1, -1, 0, -1, 0)
    EXCHANGE(s45670123, 0, 0, 0, 0, -1, -1, -1, -1)
    EXCHANGE(s23016745, 0, 0, -1, -1, 0, 0, -1, -1)
    EXCHANGE(s10325476, 0, -1, 0, -1, 0, -1, 0, -1)
    return v;
}

/// The lanes whose bits are set, largest first; all others hold -1, less than any of these. They are seldom more than four.
FUNCTION int8 sorted(int8 v, uint bits) {
#ifdef __AVX512VL__
    if (popcount(bits) <= 4) {
        v = as_int8(__builtin_ia32_compresssi256_mask(v, (int8)(-1), (uchar)bits));
        EXCHANGE(s10325476, 0, -1, 0, -1, 0, -1, 0, -1)
        EXCHANGE(s23016745, 0, 0, -1, -1, 0, 0, -1, -1)
        EXCHANGE(s02134657, 0, 0, -1, 0, 0, 0, -1, 0)
        return v;
    }
#endif
    return sorted(v);
}
#undef EXCHANGE

/// Lane i becomes values[at[i] mod 8].
FUNCTION uint8 picked(uint8 values, uint8 at) {
#ifdef __AVX2__
    return as_uint8(__builtin_ia32_permvarsi256(as_int8(values), as_int8(at)));
#else
    return shuffle(values, at);
#endif
}

/// Stores the values of the lanes whose bits are set, one after another, and anything behind them: there must be room for 8.
FUNCTION void store_picked(uint8 values, uint bits, uint *to) {
#ifdef __AVX512VL__
    vstore8(as_uint8(__builtin_ia32_compresssi256_mask(as_int8(values), (int8)(0), (uchar)bits)), 0, to);
#else
    uint lanes[8];
    vstore8(values, 0, lanes);
    for (uint lane = 0u; lane < 8u; ++lane) {
        *to = lanes[lane];
        to += bits >> lane & 1u;
    }
#endif
}
