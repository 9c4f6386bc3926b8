// From the samples of a batch to one of the pixels about theirs.
#include "kernels/core/bands.cl"
#include "kernels/core/bright_samples.cl"
#include "kernels/core/integer128.cl"
#include "kernels/core/items.cl"
#include "kernels/filters/splat.cl"
#include "kernels/filters/weighed.cl"

#define SPLATS_AT_ONCE 16u  ///< samples whose weights are computed together

/// Those of a pixel's samples first ... first + count that count in the other: their numbers from `first` on. `weights` are of all of these.
FUNCTION uint list_splats(uint first, uint count, Splat splat, const global float *filter_values, const global vec2 *places, uint *weights,
                          uint *list) {
    SIXTEEN_WIDE for (uint k = 0u; k < SPLATS_AT_ONCE; ++k) {
        const uint s = first + min(k, count - 1u);
        vec2 place;
        place.x = places[s].x, place.y = places[s].y;
        weights[k] = splat_weight(place, splat, filter_values);
    }
    uint listed = 0u;
    for (uint k = 0u; k < count; ++k) list[listed] = k, listed += weights[k] != 0u;
    return listed;
}

FUNCTION void add_splat(global FilmPixel *pixel, global PixelWeights *sums, uint half_of_sample, const int64 *values, uint weight) {
    sums->sums[half_of_sample] += weight;
    sums->squares[half_of_sample] += (uint64)weight * weight >> 30;
#pragma unroll
    for (uint c = 0u; c < 3u; ++c) {
        const int64 value = weighed(values[c], weight);
        add(&pixel->sums[half_of_sample][c], value);
        add(&pixel->squares[half_of_sample][c], (uint64)value * (uint64)values[c], (uint64)mul_hi(value, values[c]));
    }
}

/// Adds the batch's samples to the pixel that the splat leads to from theirs, as far as it is in the band: no two pixels lead to one, so that nothing
/// is added to it at once. clamped[0] counts the samples that are cut at ±2^16, where they are added to their own pixels.
kernel void add_splats(BatchParams batch, FilmBand band, Splat splat, const global float *restrict filter_values, const global uint *restrict pixels,
                       const global vec2 *restrict places, const global Sample *restrict samples, global FilmPixel *restrict film,
                       global PixelWeights *restrict weights, global uint *restrict clamped) {
    const bool own = splat.x == 0 && splat.y == 0;
    FOR_EACH_ITEM_SERIALLY(i, batch.pixels) {
        if (!leads_into_band(pixels[i], splat.x, splat.y, band)) continue;
        const uint place = place_led_to(pixels[i], splat.x, splat.y, band);
        for (uint j = 0u; j < batch.samples; j += SPLATS_AT_ONCE) {
            uint of_each[SPLATS_AT_ONCE], list[SPLATS_AT_ONCE];
            const uint first = i * batch.samples + j, count = min(batch.samples - j, SPLATS_AT_ONCE);
            const uint listed = list_splats(first, count, splat, filter_values, places, of_each, list);
            for (uint k = 0u; k < listed; ++k) {
                int64 values[3];
                const bool too_bright = cut(samples[first + list[k]].sum, values);
                if (own && too_bright) atomic_inc(clamped);
                add_splat(film + place, weights + place, batch.first_sample + j + list[k] & 1u, values, of_each[list[k]]);
            }
            for (uint k = 0u; own && k < count; ++k) film[place].counts[batch.first_sample + j + k & 1u] += 1u;
        }
    }
}
