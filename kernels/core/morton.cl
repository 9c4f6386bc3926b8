// Morton's curve (1966): a place on it is the bits of x and y in turn.
#pragma once
#include "kernels/core/portable.h"

/// The bits of x < 2^16, each followed by a 0.
FUNCTION uint spread_bits(uint x) {
    x = (x | x << 8) & 0x00ff00ffu;
    x = (x | x << 4) & 0x0f0f0f0fu;
    x = (x | x << 2) & 0x33333333u;
    return (x | x << 1) & 0x55555555u;
}

/// The place of (x, y), both below 2^16.
FUNCTION uint morton_place(uint x, uint y) { return spread_bits(x) | spread_bits(y) << 1; }

/// The even bits of x, together.
FUNCTION uint even_bits(uint x) {
    x &= 0x55555555u;
    x = (x | x >> 1) & 0x33333333u;
    x = (x | x >> 2) & 0x0f0f0f0fu;
    x = (x | x >> 4) & 0x00ff00ffu;
    return (x | x >> 8) & 0xffffu;
}
