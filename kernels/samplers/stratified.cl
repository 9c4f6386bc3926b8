// Stratified sampler: the samples of a pixel lie one in each cell of a grid.
#pragma once
#include "kernels/core/random.cl"
#include "kernels/core/portable.h"

/// Position of a pixel's sample in [0, 1)²; `columns` divides the number of samples per pixel.
FUNCTION vec2 sampler_pixel_position(uint pixel, uint sample, uint columns, uint rows, uint seed) {
    const uint random = hash(pixel ^ hash(sample ^ hash(seed)));
    const uint row = sample / columns;
    vec2 position;
    position.x = ((float)(int)(sample - row * columns) + unit_interval(random)) / (float)(int)columns;
    position.y = ((float)(int)row + unit_interval(hash(random + 1u))) / (float)(int)rows;
    return position;
}
