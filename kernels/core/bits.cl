// Bits of an integer.
#pragma once
#include "kernels/core/portable.h"

/// Number of the lowest set bit of x != 0.
FUNCTION uint lowest_bit(uint x) {
#if __has_builtin(__builtin_ctz)
    return (uint)__builtin_ctz(x);
#else
    return popcount((x & -x) - 1u);
#endif
}
