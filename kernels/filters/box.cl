// The pixel itself, uniformly.
#pragma once
#include "kernels/filters/filter.h"

/// From the pixel's left or upper edge [pixels], of the random number u in [0, 1).
FUNCTION float filter_place(float u, FILTER_PARAMS) { return u; }
