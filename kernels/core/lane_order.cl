// Order among 8 lanes, without branches.
#pragma once
#include "kernels/core/portable.h"

/// Largest first (Batcher's bitonic sort, AFIPS SJCC 1968).
FUNCTION int8 sorted(int8 v) {
#define EXCHANGE(partner, lower...)                        \
    {                                                      \
        const int8 other = v.partner;                      \
        v = (int8)(lower) ? min(v, other) : max(v, other); \
    }
    EXCHANGE(s10325476, 0, -1, -1, 0, 0, -1, -1, 0)
    EXCHANGE(s23016745, 0, 0, -1, -1, -1, -1, 0, 0)
    EXCHANGE(s10325476, 0, -1, 0, -1, -1, 0, -1, 0)
    EXCHANGE(s45670123, 0, 0, 0, 0, -1, -1, -1, -1)
    EXCHANGE(s23016745, 0, 0, -1, -1, 0, 0, -1, -1)
    EXCHANGE(s10325476, 0, -1, 0, -1, 0, -1, 0, -1)
#undef EXCHANGE
    return v;
}

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
