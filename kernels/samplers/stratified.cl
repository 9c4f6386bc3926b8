// Stratified sampler: of the samples of even number, and of those of odd number, each is anywhere in a box of its own, of a grid of 2^k boxes
// (Cook, ACM TOG 5(1) 1986); which, every use of a pixel shuffles anew.
#pragma once
#include "kernels/core/params.h"
#include "kernels/core/random.cl"
#include "kernels/samplers/part.cl"

/// The least k such that 2^k boxes are enough for as many pairs, and no more than 12 where nobody knows how many there will be.
FUNCTION uint grid_bits(uint pairs) { return min(32u - clz(pairs - 1u), 12u); }

/// A permutation of the numbers below 2^bits: each step is one, modulo 2^bits.
FUNCTION uint permuted(uint x, uint bits, uint seed) {
    const uint ones = (1u << bits) - 1u, shift = (bits >> 1) + 1u;
    x = (x ^ seed) & ones;
    x = x * (seed >> 15 | 1u) & ones;
    x ^= x >> shift;
    x = (x * 0x7feb352du + (seed >> 7)) & ones;
    x ^= x >> shift;
    return x * (seed >> 3 | 1u) & ones;
}

/// Anywhere in cell `cell` of 2^bits.
FUNCTION float in_cell(uint cell, uint bits, uint random) { return unit_interval(bits > 0u ? cell << (32u - bits) | random >> bits : random); }

/// A part's pair of numbers for a use, the `dimension` from 1 on, in [0, 1)². Those beyond a grid begin another.
FUNCTION vec2 sampler_pair(uint pixel, uint sample, Part part, uint dimension, BatchParams batch) {
    const uint bits = grid_bits(samples_of_a_half(batch) * part.count), columns = bits >> 1, number = index_of_part(sample >> 1, part);
    const uint use = dimension_of_part(dimension, part);
    const uint grid = hash(hash(pixel ^ hash((sample & 1u) ^ hash(batch.seed))) ^ hash(use ^ hash(number >> bits)));
    const uint cell = permuted(number & ((1u << bits) - 1u), bits, grid), random = hash(grid ^ hash(number + 1u));
    vec2 pair;
    pair.x = in_cell(cell & ((1u << columns) - 1u), columns, random);
    pair.y = in_cell(cell >> columns, bits - columns, hash(random + 1u));
    return pair;
}

/// Position of a pixel's sample in [0, 1)².
FUNCTION vec2 sampler_pixel_position(uint pixel, uint sample, BatchParams batch) { return sampler_pair(pixel, sample, whole_sample(), 0u, batch); }
