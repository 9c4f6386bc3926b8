// What the device can do at most, by kernels that do nothing else.
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"

#define CHAINS 8u  ///< independent ones, so that latency does not count
#define CHAIN 64u  ///< multiply-adds of each

/// Reads and writes 4 bytes per item.
kernel void copy(const global uint *restrict from, global uint *restrict to, uint count) {
    FOR_EACH_ITEM(i, count) {
        to[i] = from[i];
    }
}

/// CHAINS * CHAIN multiply-adds per item.
kernel void multiply_add(const global float *restrict from, global float *restrict to, uint count) {
    FOR_EACH_ITEM(i, count) {
        const float x = from[i];
        float a = x, b = x + 1.0f, c = x + 2.0f, d = x + 3.0f, e = x + 4.0f, f = x + 5.0f, g = x + 6.0f, h = x + 7.0f;
#pragma unroll
        for (uint k = 0u; k < CHAIN; ++k) {
            a = fma(a, x, x), b = fma(b, x, x), c = fma(c, x, x), d = fma(d, x, x);
            e = fma(e, x, x), f = fma(f, x, x), g = fma(g, x, x), h = fma(h, x, x);
        }
        to[i] = a + b + c + d + e + f + g + h;
    }
}
