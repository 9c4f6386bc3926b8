// Parts of samples: a sample that is divided takes for one use as many pairs of numbers as it has parts.
#pragma once
#include "kernels/core/lanes_1.cl"
#include "kernels/core/params.h"

/// The `number`-th, from 0 on, of `count` parts, at most MAX_BUNDLE.
typedef struct {
    uint number, count;
} Part;

FUNCTION Part part(uint number, uint count) {
    Part result;
    result.number = number, result.count = count;
    return result;
}

/// Of a sample that has no others.
FUNCTION Part whole_sample() { return part(0u, 1u); }

/// A part of a part.
FUNCTION Part part_within(Part outer, Part inner) { return part(outer.number * inner.count + inner.number, outer.count * inner.count); }

/// Parts of a sample follow each other in a sequence, in which the next sample's come after them,
FUNCTION uint index_of_part(uint sample, Part part) { return sample * part.count + part.number; }
/// and which is another for each number of parts, since samples of one pixel may differ in that. Dimensions are below 2^17.
FUNCTION uint dimension_of_part(uint dimension, Part part) { return dimension | (part.count - 1u) << 17; }

/// The part's place in [0, 1), where u in [0, 1) is the same for all parts: one in each of as many equal intervals.
FUNCTION float place_of_part(Part part, float u) {
    return part.count == 1u ? u : minimum(((float)(int)part.number + u) / (float)(int)part.count, 0.99999994f);
}

/// How many samples of a pixel are of even number, at least as many as of odd number; 2^16 stand for more.
FUNCTION uint samples_of_a_half(BatchParams batch) { return clamp((batch.spp + 1u) >> 1, 1u, 1u << 16); }
