// The samples of a batch.
#pragma once
#include "generated/sampler.cl"

/// Which sample of which pixel (x in the lower 16 bits, y in the upper) an entry of a batch is.
typedef struct {
    uint pixel, sample;
} PixelSample;

FUNCTION PixelSample pixel_sample(uint slot, BatchParams batch, const global uint *restrict pixels) {
    const uint entry = slot / batch.samples;
    PixelSample result;
    result.pixel = pixels[entry], result.sample = batch.first_sample + (slot - entry * batch.samples);
    return result;
}

/// Where in the unit square a sample lies, of which filters make its place: in the middle where it is the only one and should be there.
FUNCTION vec2 place_in_square(PixelSample which, BatchParams batch) {
    const vec2 jitter = sampler_pixel_position(which.pixel, which.sample, batch);
    const bool is_jittered = (batch.position == PIXEL_RANDOM) | (batch.spp > 1u);
    vec2 place;
    place.x = is_jittered ? jitter.x : 0.5f, place.y = is_jittered ? jitter.y : 0.5f;
    return place;
}
