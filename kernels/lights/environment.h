/// The picture all around as a light: directions are chosen by the brightness of its parts.
#pragma once
#include "kernels/core/portable.h"

// So many cells of equal angles the picture has at most, whatever its own size.
#define MAX_ENVIRONMENT_ROWS 512u
#define MAX_ENVIRONMENT_COLUMNS 1024u

/// View of Light.words.
typedef struct {
    float radiance;  ///< mean of all directions and channels
} Environment;

// Of every so many cells of a row one is a mark: who searches a row finds the marks of all rows in a near cache, and then the cells from one mark to
// the next in one of its lines, for which rows are a multiple of a line apart.
#define ENVIRONMENT_MARK 16u
#define MAX_ENVIRONMENT_MARKS (MAX_ENVIRONMENT_COLUMNS / ENVIRONMENT_MARK)
/// From one row's first cell to the next row's, where there is room for the end of the last one.
#define ENVIRONMENT_STRIDE(columns) (((columns) / ENVIRONMENT_MARK + 1u) * ENVIRONMENT_MARK)

/// A row of cells, from the top. Numbers from `begin` up to that of the next row choose it; behind the last row is one more. Like the numbers these
/// are multiples of 2^-24, so that chances are exact. So are the numbers that choose a cell of a row, from its begin up to that of the next cell or
/// 1; of several cells that begin at one number they choose the last.
typedef struct {
    float begin;
    float high;     ///< cosine of the angle to the y axis at its upper edge
    float density;  ///< of directions in a cell, over that of uniform ones and the chance of the cell in its row
} EnvironmentRow;
