// From exact sums to a picture.
#include "kernels/core/halves.cl"
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"

/// picture[i] is the mean radiance of pixel i, row by row from the top; black where there is no sample.
kernel void develop(uint count, const global FilmPixel *restrict film, global Spectrum *restrict picture) {
    FOR_EACH_ITEM(i, count) {
        const float scale = 0x1p-32f / (float)(int)max(film[i].counts[0] + film[i].counts[1], 1u);
        picture[i] = make3(sum_of_halves(film + i, 0u) * scale, sum_of_halves(film + i, 1u) * scale, sum_of_halves(film + i, 2u) * scale);
    }
}
