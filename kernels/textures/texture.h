/// A picture in the buffer of texels.
#pragma once
#include "kernels/core/portable.h"

#define TEXTURE_CLAMPS_U 1u  ///< beyond the left and right edges lies the edge, else the picture again
#define TEXTURE_CLAMPS_V 2u  ///< the same beyond the upper and lower edges

/// Three half floats, linear, finite and not negative: words of their own, since no device gathers halves of words.
typedef struct {
    uint red_green, blue;  ///< red in the lower half
} Texel;

/// Its texels are offset + row * width + column, rows from the top.
typedef struct {
    uint offset, width, height, flags;
} TextureRecord;
