/// Uniform grid: a box divided into equal cells along every axis.
#pragma once
#include "kernels/accelerators/cells.h"

/// Plane i of an axis lies at low + i * size, rounded twice, as host and device both compute it.
typedef struct {
    CellSpans spans;  ///< cells: per cell the first item of its list or NO_ITEMS; x runs fastest, then y
    vec3 low, size;   ///< of the grid; of a cell
    uint columns[3];  ///< cells along each axis
} UniformGrid;
