/// A picture in the buffer of texels.
#pragma once
#include "kernels/core/portable.h"

#define TEXTURE_CLAMPS_U 1u  ///< beyond the left and right edges lies the edge, else the picture again
#define TEXTURE_CLAMPS_V 2u  ///< the same beyond the upper and lower edges

/// Its texels are offset + row * width + column, rows from the top: three half floats each, linear, finite and not negative.
typedef struct {
    uint offset, width, height, flags;
} TextureRecord;
