/// What a structure does for rays, in the words of Havran and Sixta (Comparison of Hierarchical Grids, Ray Tracing News 12(1), 1999).
#pragma once
#include "kernels/core/portable.h"

/// Sums over rays; 36 bytes.
typedef struct {
    uint steps;        ///< N_TS: cells or nodes that rays come to, empty ones too
    uint cells;        ///< N_ETS: of these, cells that have no further ones inside
    uint empty_cells;  ///< N_EETS: of these, those in which there is nothing
    uint listed;       ///< N_IT as a structure without mailboxes would have it: primitives in all these cells
    uint blocks;       ///< blocks of up to 8 that are tested, of primitives or of instances
    uint tests;        ///< primitives that are tested: all of those blocks
    uint missed;       ///< rays that miss a volume round objects,
    uint idle;         ///< that enter one and meet no object in it,
    uint served;       ///< and that do
} Work;
