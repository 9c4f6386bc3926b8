// Independent sampler: every sample lies anywhere in its pixel, whatever the others do.
#pragma once
#include "kernels/core/params.h"
#include "kernels/core/random.cl"
#include "kernels/samplers/part.cl"

/// A part's pair of numbers for a use, the `dimension` from 1 on, in [0, 1)².
FUNCTION vec2 sampler_pair(uint pixel, uint sample, Part part, uint dimension, BatchParams batch) {
    const uint random = hash(hash(pixel ^ hash(index_of_part(sample, part) ^ hash(batch.seed))) ^ hash(dimension_of_part(dimension, part)));
    vec2 pair;
    pair.x = unit_interval(random);
    pair.y = unit_interval(hash(random + 1u));
    return pair;
}

/// Position of a pixel's sample in [0, 1)².
FUNCTION vec2 sampler_pixel_position(uint pixel, uint sample, BatchParams batch) {
    const uint random = hash(pixel ^ hash(sample ^ hash(batch.seed)));
    vec2 position;
    position.x = unit_interval(random);
    position.y = unit_interval(hash(random + 1u));
    return position;
}
