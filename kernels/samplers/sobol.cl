// Sobol sampler: a pixel's samples of even number are the first points of one (0, 2)-sequence, those of odd number of another, each
// scrambled. Of any number of samples the halves are independent, and each is unbiased and well stratified.
#pragma once
#include "kernels/core/params.h"
#include "kernels/core/random.cl"
#include "kernels/samplers/part.cl"
#include "kernels/samplers/sobol_sequence.cl"

FUNCTION uint sequence_of_sample(uint pixel, uint sample, BatchParams batch) { return hash(pixel ^ hash((sample & 1u) ^ hash(batch.seed))); }

/// A part's pair of numbers for a use, the `dimension` from 1 on, in [0, 1)². Each use has a sequence of its own, and takes its points in an order
/// of its own that keeps every 2^k aligned ones together, so that uses are independent of each other (Burley 2020).
FUNCTION vec2 sampler_pair(uint pixel, uint sample, Part part, uint dimension, BatchParams batch) {
    const uint seed = hash(sequence_of_sample(pixel, sample, batch) ^ hash(dimension_of_part(dimension, part)));
    return sobol_point(shuffled_index(index_of_part(sample >> 1, part), hash(seed + 2u)), seed);
}

/// Position of a pixel's sample in [0, 1)².
FUNCTION vec2 sampler_pixel_position(uint pixel, uint sample, BatchParams batch) {
    return sobol_point(sample >> 1, sequence_of_sample(pixel, sample, batch));
}
