// From the samples of a batch to the film.
#include "kernels/core/bands.cl"
#include "kernels/core/bright_samples.cl"
#include "kernels/core/integer128.cl"
#include "kernels/core/items.cl"

/// Adds the batch's samples to their pixels, as far as these are in the band; clamped[0] counts the samples that were cut at ±2^16.
kernel void add_samples(BatchParams batch, FilmBand band, const global uint *restrict pixels, const global Sample *restrict samples,
                        global FilmPixel *restrict film, global uint *restrict clamped) {
    FOR_EACH_ITEM_SERIALLY(i, batch.pixels) {
        if (!is_in_band(pixels[i], band)) continue;
        global FilmPixel *pixel = film + place_in_band(pixels[i], band);
        for (uint j = 0u; j < batch.samples; ++j) {
            const uint half_of_sample = batch.first_sample + j & 1u;
            int64 values[3];
            if (cut(samples[i * batch.samples + j].sum, values)) atomic_inc(clamped);
            for (uint c = 0u; c < 3u; ++c) {
                add(&pixel->sums[half_of_sample][c], values[c]);
                const Integer128 square = product(values[c], values[c]);
                add(&pixel->squares[half_of_sample][c], square.low, square.high);
            }
            pixel->counts[half_of_sample] += 1u;
        }
    }
}
