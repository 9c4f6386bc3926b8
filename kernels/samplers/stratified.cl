// Stratified sampler: a pixel's samples of even number lie one in each cell of a grid, those of odd number one in each cell of another.
#pragma once
#include "kernels/core/math.cl"
#include "kernels/core/params.h"
#include "kernels/core/random.cl"

/// In cell `place` of `count` between 0 and 1: from the cell's beginning on and before its end, both rounded to float.
FUNCTION float stratum(uint place, uint count, uint random) {
    const float cells = (float)(int)count, end = (float)(int)(place + 1u) / cells;
    return minimum(((float)(int)place + unit_interval(random)) / cells, next_down(end));
}

/// Position of a pixel's sample in [0, 1)². The two halves are independent, so that each alone is an unbiased estimate of the pixel.
FUNCTION vec2 sampler_pixel_position(uint pixel, uint sample, BatchParams batch) {
    const bool odd = (sample & 1u) != 0u;
    const uint columns = odd ? batch.columns[1] : batch.columns[0], rows = odd ? batch.rows[1] : batch.rows[0];
    const uint place = sample >> 1, row = place / columns;
    const uint random = hash(pixel ^ hash(sample ^ hash(batch.seed)));
    vec2 position;
    position.x = stratum(place - row * columns, columns, random);
    position.y = stratum(row, rows, hash(random + 1u));
    return position;
}
