// Where a pixel (x in the lower 16 bits, y in the upper) is in a band of the film.
#pragma once
#include "kernels/core/params.h"

/// Whether the pixel that lies (x, y) to the right and below is in the band: what is above or to the left wraps around.
FUNCTION bool leads_into_band(uint pixel, int x, int y, FilmBand band) {
    return (pixel >> 16) + (uint)y - band.first_row < band.rows && (pixel & 0xffffu) + (uint)x - band.first_column < band.width;
}
FUNCTION uint place_led_to(uint pixel, int x, int y, FilmBand band) {
    return ((pixel >> 16) + (uint)y - band.first_row) * band.width + ((pixel & 0xffffu) + (uint)x - band.first_column);
}
FUNCTION bool is_in_band(uint pixel, FilmBand band) { return leads_into_band(pixel, 0, 0, band); }
FUNCTION uint place_in_band(uint pixel, FilmBand band) { return place_led_to(pixel, 0, 0, band); }
