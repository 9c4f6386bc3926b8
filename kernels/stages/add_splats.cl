// From the samples of a batch to one of the pixels about theirs.
#include "kernels/core/bands.cl"
#include "kernels/core/integer128.cl"
#include "kernels/core/items.cl"
#include "kernels/filters/splat.cl"
#include "kernels/filters/weighed.cl"

#define SAMPLES_AT_ONCE 4096u  ///< of a pixel: so few that 64 bits hold the columns' sums
#define DIGIT 24u              ///< bits of a product's digits: values that are cut have two

/// Columns of a chunk of pixels: sums of samples of one half.
typedef struct {
    int64 values[3][ITEMS_PER_WORK_ITEM];
    uint64 squares[3][3][ITEMS_PER_WORK_ITEM];  ///< by channel and place of a digit, the lowest first
    uint64 weights[ITEMS_PER_WORK_ITEM], squared_weights[ITEMS_PER_WORK_ITEM];
} SplatColumns;

FUNCTION void clear_columns(SplatColumns *sums) {
    FOR_EACH_COLUMN(i) {
        sums->weights[i] = 0ul, sums->squared_weights[i] = 0ul;
#pragma unroll
        for (uint c = 0u; c < 3u; ++c) {
            sums->values[c][i] = 0l;
            sums->squares[c][0][i] = 0ul, sums->squares[c][1][i] = 0ul, sums->squares[c][2][i] = 0ul;
        }
    }
}

/// One sample of every pixel of the chunk.
FUNCTION void add_to_columns(SplatColumns *sums, const global float *in_column, const global float *in_row, const global int64 *values, uint stride) {
    FOR_EACH_COLUMN(i) {
        const uint weight = splat_weight(in_column[i], in_row[i]);
        sums->weights[i] += weight;
        sums->squared_weights[i] += (uint64)weight * weight >> 30;
#pragma unroll
        for (uint c = 0u; c < 3u; ++c) {
            const int64 value = values[c * stride + i];
            const uint64 a = (uint64)abs(value), b = weighed(a, weight), mask = (1ul << DIGIT) - 1ul, high = 2ul * mask + 1ul;
            sums->values[c][i] += value < 0l ? -(int64)b : (int64)b;
            const uint64 a0 = a & mask, a1 = a >> DIGIT & high, b0 = b & mask, b1 = b >> DIGIT & high;
            sums->squares[c][0][i] += a0 * b0, sums->squares[c][1][i] += a0 * b1 + a1 * b0, sums->squares[c][2][i] += a1 * b1;
        }
    }
}

/// digits[place] of the column i, as one number.
FUNCTION Integer128 number_of(const uint64 (*digits)[ITEMS_PER_WORK_ITEM], uint i) {
    const Integer128 low = {digits[0][i], 0ul}, middle = {digits[1][i] << DIGIT, digits[1][i] >> (64u - DIGIT)};
    const Integer128 high = {digits[2][i] << 2u * DIGIT, digits[2][i] >> (64u - 2u * DIGIT)};
    return plus(plus(low, middle), high);
}

FUNCTION void add_column(const SplatColumns *sums, uint i, uint half_of_samples, global FilmPixel *pixel, global PixelWeights *weights) {
    weights->sums[half_of_samples] += sums->weights[i];
    weights->squares[half_of_samples] += sums->squared_weights[i];
#pragma unroll
    for (uint c = 0u; c < 3u; ++c) {
        const Integer128 squares = number_of(sums->squares[c], i);
        add(&pixel->sums[half_of_samples][c], sums->values[c][i]);
        add(&pixel->squares[half_of_samples][c], squares.low, squares.high);
    }
}

/// Adds the batch's samples to the pixel that the splat leads to from theirs, as far as it is in the band: no two pixels lead to one, so that nothing
/// is added to it at once. What is of a pixel's own samples alone, their number, comes with the splat that leads to itself.
/// `splat_weights`: of weigh_splats, `values`: of cut_samples; a chunk's columns more than the batch's samples may be read of both.
kernel void add_splats(BatchParams batch, FilmBand band, Splat splat, const global float *restrict splat_weights, const global int64 *restrict values,
                       uint stride, const global uint *restrict pixels, global FilmPixel *restrict film, global PixelWeights *restrict weights) {
    const Chunk chunk = chunk_of(batch.pixels);
    for (uint first = 0u; first < batch.samples && chunk.items != 0u; first += SAMPLES_AT_ONCE) {
        const uint last = min(batch.samples, first + SAMPLES_AT_ONCE);
        for (uint h = 0u; h < 2u; ++h) {
            SplatColumns sums;
            clear_columns(&sums);
            uint count = 0u;
            for (uint j = first + (batch.first_sample + first + h & 1u); j < last; j += 2u, ++count) {
                const uint at = j * batch.pixels + chunk.begin;
                add_to_columns(&sums, splat_weights + splat.along_x + at, splat_weights + splat.along_y + at, values + at, stride);
            }
            for (uint i = 0u; i < chunk.items; ++i) {
                const uint pixel = pixels[chunk.begin + i];
                if (!leads_into_band(pixel, splat.x, splat.y, band)) continue;
                const uint place = place_led_to(pixel, splat.x, splat.y, band);
                if (sums.weights[i] != 0ul) add_column(&sums, i, h, film + place, weights + place);
                if (splat.x == 0 && splat.y == 0) film[place].counts[h] += count;
            }
        }
    }
}
