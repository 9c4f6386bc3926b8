// Points of (0, 2)-sequences (Sobol 1967), scrambled after Owen (1995): the first 2^k lie one in each of 2^k equal boxes, of whatever proportions in
// powers of two, and so do any 2^k aligned ones.
#pragma once
#include "kernels/core/random.cl"

#ifndef __has_builtin
#define __has_builtin(name) 0
#endif

/// Bit 31 becomes bit 0.
FUNCTION uint bits_reversed(uint x) {
#if __has_builtin(__builtin_bitreverse32)
    return __builtin_bitreverse32(x);
#else
    x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
    x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
    x = (x & 0x0f0f0f0fu) << 4 | (x >> 4 & 0x0f0f0f0fu);
    x = (x & 0x00ff00ffu) << 8 | (x >> 8 & 0x00ff00ffu);
    return x << 16 | x >> 16;
#endif
}

/// Binary digits of the second coordinate of a point, the first after the point lowest; those of the first are its index. Digit i is the sum
/// modulo 2 of the index's bits j with an odd binomial coefficient j over i, that is (Lucas) those j that have all bits of i.
FUNCTION uint sobol_second_digits(uint index) {
    index ^= (index & 0xaaaaaaaau) >> 1;
    index ^= (index & 0xccccccccu) >> 2;
    index ^= (index & 0xf0f0f0f0u) >> 4;
    index ^= (index & 0xff00ff00u) >> 8;
    return index ^ index >> 16;
}

/// Each digit is flipped or not by a hash of the seed and of the digits before it, which are the lower bits (Laine & Karras, EGSR 2011, section 3.1;
/// the constants are Vegdahl's of 2021, see Burley, JCGT 9(4) 2020, for the use).
FUNCTION uint owen_scrambled(uint digits, uint seed) {
    digits ^= digits * 0x3d20adeau;
    digits += seed;
    digits *= seed >> 16 | 1u;
    digits ^= digits * 0x05526c56u;
    return digits ^ digits * 0x53a22864u;
}

/// The point of this index of the sequence that the seed chooses, in [0, 1)².
FUNCTION vec2 sobol_point(uint index, uint seed) {
    vec2 point;
    point.x = unit_interval(bits_reversed(owen_scrambled(index, seed)));
    point.y = unit_interval(bits_reversed(owen_scrambled(sobol_second_digits(index), hash(seed + 1u))));
    return point;
}

/// The index that a use of a sequence has its point from: in an order of its own, which keeps every 2^k aligned points together (Burley 2020).
FUNCTION uint shuffled_index(uint index, uint seed) { return bits_reversed(owen_scrambled(bits_reversed(index), seed)); }
