// Integers of 128 bits, for sums that cannot wrap.
#pragma once
#include "kernels/core/items.h"

FUNCTION void add(global Integer128 *sum, uint64 low, uint64 high) {
    sum->low += low;
    sum->high += high + (sum->low < low);
}

FUNCTION void add(global Integer128 *sum, int64 value) { add(sum, (uint64)value, (uint64)(value >> 63)); }

/// As add(), while other work-items add to the same sum: which of them carries into the upper half depends on their order, the result does not.
FUNCTION void add_atomically(global Integer128 *sum, int64 value) {
    const uint64 low = (uint64)value, before = atom_add(&sum->low, low);
    const uint64 high = (uint64)(value >> 63) + (before + low < low);
    if (high != 0ul) atom_add(&sum->high, high);
}

/// Exact. On a processor one multiplication; mul_hi of PoCL takes four of halves.
FUNCTION Integer128 product(int64 a, int64 b) {
    Integer128 result;
#ifdef __SIZEOF_INT128__
    const __int128 wide = (__int128)a * b;
    result.low = (uint64)wide, result.high = (uint64)(wide >> 64);
#else
    result.low = (uint64)a * (uint64)b, result.high = (uint64)mul_hi(a, b);
#endif
    return result;
}

/// The nearest number in [-limit, limit].
FUNCTION int64 nearest_within(int64 limit, Integer128 x) {
    const int64 low = (int64)x.low, high = (int64)x.high;
    const bool fits = high == low >> 63;
    return fits ? clamp(low, -limit, limit) : high < 0l ? -limit : limit;
}

FUNCTION bool equal(Integer128 a, int64 b) { return (a.low == (uint64)b) & (a.high == (uint64)(b >> 63)); }

FUNCTION Integer128 plus(Integer128 a, Integer128 b) {
    Integer128 sum;
    sum.low = a.low + b.low;
    sum.high = a.high + b.high + (sum.low < b.low);
    return sum;
}

/// Relative error at most 2^-23; to the nearest where the magnitude is below 2^64.
FUNCTION float to_float(Integer128 x) {
    const bool negative = (int64)x.high < 0l;
    const uint64 low = negative ? -x.low : x.low, high = negative ? ~x.high + (x.low == 0ul) : x.high;
    const float magnitude = fma((float)high, 0x1p64f, (float)low);
    return negative ? -magnitude : magnitude;
}
