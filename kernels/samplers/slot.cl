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
