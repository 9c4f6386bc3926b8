// A tent: 1 - |x| / radius.
#pragma once
#include "kernels/filters/filter.h"
#include "kernels/filters/half.cl"

/// From the pixel's left or upper edge [pixels], of the random number u in [0, 1). The part (1 - x / radius)² of a tent's mass lies beyond x.
FUNCTION float filter_place(float u, FILTER_PARAMS) { return place_at(u, filter.radius * (1.0f - sqrt(mass_beyond(u)))); }
