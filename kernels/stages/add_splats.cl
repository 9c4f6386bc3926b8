// From the samples of a batch to one of the pixels about theirs.
#include "kernels/core/bands.cl"
#include "kernels/core/bits.cl"
#include "kernels/core/bright_samples.cl"
#include "kernels/core/integer128.cl"
#include "kernels/core/items.cl"
#include "kernels/core/lanes_16.cl"
#include "kernels/filters/splat.cl"
#include "kernels/filters/weighed.cl"

#include "kernels/core/lanes_1.cl"

#define SPLATS_AT_ONCE 16u  ///< samples whose weights are computed together

/// What some samples of one half add to a pixel: so few that an int64 holds their values' sum.
typedef struct {
    int64 sums[3];
    Integer128 squares[3];
    uint64 weight, squared_weight;
} SplatSums;

/// Bits of a half's samples among those from `sample` on.
FUNCTION uint lanes_of_half(uint half_of_samples, uint sample) { return (half_of_samples ^ sample) & 1u ? 0xaaaau : 0x5555u; }

/// Bits of those of the first `count` samples that count in the pixel that the splat leads to.
FUNCTION uint weigh_some(const global float *in_column, const global float *in_row, uint count, uint *weights) {
    SIXTEEN_WIDE for (uint k = 0u; k < SPLATS_AT_ONCE; ++k) weights[k] = splat_weight(in_column[k], in_row[k]);
    return mask_bits(vload16(0, weights) != (uint16)(0u)) & ((1u << count) - 1u);
}

FUNCTION void add_splat(SplatSums *sums, const int64 *values, uint weight) {
    sums->weight += weight;
    sums->squared_weight += (uint64)weight * weight >> 30;
#pragma unroll
    for (uint c = 0u; c < 3u; ++c) {
        const int64 value = weighed(values[c], weight);
        sums->sums[c] += value;
        sums->squares[c] = plus(sums->squares[c], product(value, values[c]));
    }
}

/// Of the samples whose bits are set.
FUNCTION SplatSums sum_of_splats(const global Sample *samples, const uint *weights, uint bits) {
    const Integer128 zero = {0ul, 0ul};
    SplatSums sums = {{0l, 0l, 0l}, {zero, zero, zero}, 0ul, 0ul};
    for (; bits != 0u; bits &= bits - 1u) {
        const uint k = lowest_bit(bits);
        int64 values[3];
        cut(samples[k].sum, values);
        add_splat(&sums, values, weights[k]);
    }
    return sums;
}

FUNCTION void add_sums(SplatSums sums, uint half_of_samples, global FilmPixel *pixel, global PixelWeights *weights) {
    weights->sums[half_of_samples] += sums.weight;
    weights->squares[half_of_samples] += sums.squared_weight;
#pragma unroll
    for (uint c = 0u; c < 3u; ++c) {
        add(&pixel->sums[half_of_samples][c], sums.sums[c]);
        add(&pixel->squares[half_of_samples][c], sums.squares[c].low, sums.squares[c].high);
    }
}

/// Of a pixel's own samples: their number, and in clamped[0] those that are cut at ±2^16.
FUNCTION void count_samples(const global Sample *samples, BatchParams batch, global FilmPixel *pixel, global uint *clamped) {
    for (uint j = 0u; j < batch.samples; ++j) {
        int64 values[3];
        if (cut(samples[j].sum, values)) atomic_inc(clamped);
        pixel->counts[batch.first_sample + j & 1u] += 1u;
    }
}

/// Adds the batch's samples to the pixel that the splat leads to from theirs, as far as it is in the band: no two pixels lead to one, so that nothing
/// is added to it at once. What is of a pixel's own samples alone comes with the splat that leads to itself. `splat_weights`: of weigh_splats, and
/// SPLATS_AT_ONCE more that do not count.
kernel void add_splats(BatchParams batch, FilmBand band, Splat splat, const global float *restrict splat_weights, const global uint *restrict pixels,
                       const global Sample *restrict samples, global FilmPixel *restrict film, global PixelWeights *restrict weights,
                       global uint *restrict clamped) {
    FOR_EACH_ITEM_SERIALLY(i, batch.pixels) {
        if (!leads_into_band(pixels[i], splat.x, splat.y, band)) continue;
        const uint place = place_led_to(pixels[i], splat.x, splat.y, band);
        for (uint j = 0u; j < batch.samples; j += SPLATS_AT_ONCE) {
            uint of_each[SPLATS_AT_ONCE];
            const uint first = i * batch.samples + j, count = min(batch.samples - j, SPLATS_AT_ONCE);
            const uint some = weigh_some(splat_weights + splat.along_x + first, splat_weights + splat.along_y + first, count, of_each);
            for (uint h = 0u; h < 2u; ++h) {
                const uint bits = some & lanes_of_half(h, batch.first_sample + j);
                if (bits != 0u) add_sums(sum_of_splats(samples + first, of_each, bits), h, film + place, weights + place);
            }
        }
        if (splat.x == 0 && splat.y == 0) count_samples(samples + i * batch.samples, batch, film + place, clamped);
    }
}
