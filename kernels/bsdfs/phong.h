/// A diffuse surface with a highlight, which reflects no more than arrives.
#pragma once
#include "kernels/core/portable.h"

/// View of Material.words.
typedef struct {
    Spectrum diffuse, specular;  ///< reflectances
    float exponent;              ///< of the highlight
} ModifiedPhong;
