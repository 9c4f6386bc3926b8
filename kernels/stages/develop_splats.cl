// From exact sums of splats to a picture.
#include "kernels/core/halves.cl"
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"

/// picture[i] is the mean radiance of pixel i over what its samples weigh, row by row from the top; black where there is no sample.
kernel void develop_splats(uint count, const global FilmPixel *restrict film, const global PixelWeights *restrict weights,
                           global Spectrum *restrict picture) {
    FOR_EACH_ITEM(i, count) {
        const uint64 weight = weights[i].sums[0] + weights[i].sums[1];
        const float scale = weight == 0ul ? 0.0f : 0x1p-2f / (float)weight;
        picture[i] = make3(sum_of_halves(film + i, 0u) * scale, sum_of_halves(film + i, 1u) * scale, sum_of_halves(film + i, 2u) * scale);
    }
}
