/// Splatting: samples lie evenly in their pixels, and count in all pixels that the filter reaches from there.
#pragma once
#include "kernels/core/portable.h"

#define SPLAT_UNIT (1u << 30)  ///< a weight of 1, the filter's at its centre

/// From pixels to those that lie (x, y) to the right and below.
typedef struct {
    int x, y;         ///< [pixels]
    float intervals;  ///< of the filter's table in a pixel's width
} Splat;
