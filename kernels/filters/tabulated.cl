// Filters whose inverse distribution function is a table. It is one of a tent's, so that what lies far out has intervals enough.
#pragma once
#include "kernels/filters/filter.h"
#include "kernels/filters/half.cl"

/// From the pixel's left or upper edge [pixels], of the random number u in [0, 1).
FUNCTION float filter_place(float u, FILTER_PARAMS) {
    const float x = (1.0f - sqrt(mass_beyond(u))) * (float)(int)FILTER_INTERVALS;
    const int i = min((int)x, (int)FILTER_INTERVALS - 1);
    const float before = filter_table[i];
    return place_at(u, fma(x - (float)i, filter_table[i + 1] - before, before));
}
