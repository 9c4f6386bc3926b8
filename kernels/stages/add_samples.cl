// From the samples of a batch to the film.
#include "kernels/core/items.cl"
#include "kernels/core/params.h"

#define LARGEST_SAMPLE (1l << 48)  ///< 2^16

/// Adds the batch's samples to their pixels, one work-item a pixel; clamped[0] counts the samples that were cut at ±2^16.
kernel void add_samples(BatchParams batch, uint width, const global uint *restrict pixels, const global Sample *restrict samples,
                        global FilmPixel *restrict film, global uint *restrict clamped) {
    FOR_EACH_ITEM_SERIALLY(i, batch.pixels) {
        global FilmPixel *pixel = film + (pixels[i] >> 16) * width + (pixels[i] & 0xffffu);
        for (uint j = 0u; j < batch.samples; ++j) {
            const bool odd = (batch.first_sample + j & 1u) != 0u;
            bool cut = false;
            for (uint c = 0u; c < 3u; ++c) {
                const int64 sum = samples[i * batch.samples + j].sum[c];
                const int64 value = clamp(sum, -LARGEST_SAMPLE, LARGEST_SAMPLE);
                cut |= value != sum;
                pixel->sum[c] += value;
                pixel->odd[c] += odd ? value : 0l;
                const uint64 low = (uint64)value * (uint64)value;
                pixel->squares[c][0] += low;
                pixel->squares[c][1] += (uint64)mul_hi(value, value) + (pixel->squares[c][0] < low);
            }
            if (cut) atomic_inc(clamped);
            pixel->count += 1u;
            pixel->odd_count += odd;
        }
    }
}
