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

/// A row of cells, from the top. Numbers in [begin, end) choose it; both are multiples of 2^-24, of which the numbers are, so that chances are exact.
typedef struct {
    float begin, end;
    float high, low;  ///< cosine of the angle to the y axis at its upper and lower edge
} EnvironmentRow;

/// A part of a row. Numbers in [begin, end), multiples of 2^-24 again, choose it of its row; of several cells that begin at one number, the last.
typedef struct {
    float begin, end;
    float density;  ///< of directions in it, over that of uniform ones
} EnvironmentCell;
