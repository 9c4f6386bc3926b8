// Of which samples the weight is negative, where a filter is.
#pragma once
#include "kernels/filters/filter.h"
#include "kernels/filters/half.cl"
#include "kernels/samplers/slot.cl"

/// Outermost in one direction and not in the other: f(x) f(y) < 0.
FUNCTION bool has_negative_weight(PixelSample which, BatchParams batch, FilterParams filter) {
    const vec2 random = sampler_pixel_position(which.pixel, which.sample, batch);
    return (mass_beyond(random.x) < filter.negative_tail) != (mass_beyond(random.y) < filter.negative_tail);
}
