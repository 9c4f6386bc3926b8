/// Light that rough dielectrics' facets take from each other, as the host computes it for facets of one alpha and distribution.
#pragma once
#include "kernels/core/portable.h"

#define LOSS_ETAS 48
#define LOSS_COSINES 48

/// At an interface of one ratio of indices.
typedef struct {
    float mean;              ///< of light from everywhere
    float at[LOSS_COSINES];  ///< of light at a cosine z: at places even in z (1 + alpha) / (z + alpha), from 0 to 1
} LossRow;

/// Parts of the light that leave the surface neither by one mirroring nor by one refraction.
typedef struct {
    /// Of light from the side of the lower index, and of the higher one; at ratios r of the higher to the lower one, from 1 to infinity, that are
    /// even in q / (q + 1/2), q² = r - 1: from the denser side losses are the largest near the critical angle, whose cosine is nearly proportional to
    /// q.
    LossRow rows[2][LOSS_ETAS];
} LossTable;
