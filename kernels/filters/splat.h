/// Splatting: samples lie evenly in their pixels, and count in all pixels that the filter reaches from there.
#pragma once
#include "kernels/core/portable.h"

#define SPLAT_UNIT (1u << 30)  ///< a weight of 1, the filter's at its centre

/// From pixels to those that lie (x, y) to the right and below.
typedef struct {
    int x, y;               ///< [pixels]
    uint along_x, along_y;  ///< where the weights of samples in such a column, and in such a row, begin among those of weigh_splats
} Splat;
