// Where a pixel (x in the lower 16 bits, y in the upper) is in a band of the film.
#pragma once
#include "kernels/core/params.h"

FUNCTION bool is_in_band(uint pixel, FilmBand band) { return (pixel >> 16) - band.first_row < band.rows; }  // above the band it wraps around
FUNCTION uint place_in_band(uint pixel, FilmBand band) {
    return ((pixel >> 16) - band.first_row) * band.width + ((pixel & 0xffffu) - band.first_column);
}
