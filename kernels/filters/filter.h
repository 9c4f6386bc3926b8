/// A reconstruction filter |f(x)| |f(y)|, from which the samples' places in their pixel are drawn.
#pragma once
#include "kernels/core/portable.h"

#define FILTER_INTERVALS 2048u  ///< of a table of the inverse distribution function

typedef struct {
    float radius;         ///< beyond it the filter is 0 [pixels]
    float negative_tail;  ///< part of the mass of |f(x)| that lies outermost, where f is negative
    uint weight;          ///< magnitude of every sample's weight, (∫|f| / ∫f)², in units of 2^-30
} FilterParams;

#ifndef __cplusplus
/// A table has FILTER_INTERVALS + 1 distances from the pixel's centre [pixels]: that which a part (1 - i / FILTER_INTERVALS)² of the mass of |f|
/// lies beyond.
#define FILTER_PARAMS FilterParams filter, const global float *restrict filter_table
#endif
