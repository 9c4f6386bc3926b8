// The film's two halves of samples, together.
#pragma once
#include "kernels/core/integer128.cl"
#include "kernels/core/items.h"

FUNCTION float sum_of_halves(const global FilmPixel *pixel, uint c) { return to_float(plus(pixel->sums[0][c], pixel->sums[1][c])); }
