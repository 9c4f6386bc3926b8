// Sobol's points again, but dealt out along a curve through the pixels (Ahmed & Wonka, ACM TOG 39(6) 2020, without their choice of a curve): a
// pixel's samples are a run of one sequence, those of a square of 2^k by 2^k pixels too, and what is left of errors is blue: neighbours' cancel each
// other.
#pragma once
#include "kernels/core/morton.cl"
#include "kernels/core/params.h"
#include "kernels/core/random.cl"
#include "kernels/samplers/part.cl"
#include "kernels/samplers/sobol_sequence.cl"

/// Place of a pixel on Morton's curve.
FUNCTION uint place_on_curve(uint pixel) { return morton_place(pixel & 0xffffu, pixel >> 16); }

/// Of a run: the least k such that as many pairs are at most 2^k, and no more than 16 where nobody knows how many there will be.
FUNCTION uint run_bits(uint pairs) { return min(32u - clz(pairs - 1u), 16u); }

/// A part's place in its sequence, which the seed names; where 32 bits do not hold all pixels' runs, there are several.
typedef struct {
    uint index, seed;
} PlaceInSequence;

FUNCTION PlaceInSequence place_in_sequence(uint pixel, uint sample, Part part, uint dimension, BatchParams batch) {
    const uint bits = run_bits(samples_of_a_half(batch) * part.count), number = index_of_part(sample >> 1, part), curve = place_on_curve(pixel);
    PlaceInSequence place;
    place.index = curve << bits | (number & ((1u << bits) - 1u));
    const uint beyond = (bits > 0u ? curve >> (32u - bits) : 0u) ^ hash(number >> bits);
    place.seed = hash(beyond ^ hash((sample & 1u) ^ hash(batch.seed ^ hash(dimension_of_part(dimension, part)))));
    return place;
}

/// A part's pair of numbers for a use, the `dimension` from 1 on, in [0, 1)².
FUNCTION vec2 sampler_pair(uint pixel, uint sample, Part part, uint dimension, BatchParams batch) {
    const PlaceInSequence place = place_in_sequence(pixel, sample, part, dimension, batch);
    return sobol_point(shuffled_index(place.index, hash(place.seed + 2u)), place.seed);
}

/// Position of a pixel's sample in [0, 1)².
FUNCTION vec2 sampler_pixel_position(uint pixel, uint sample, BatchParams batch) { return sampler_pair(pixel, sample, whole_sample(), 0u, batch); }
