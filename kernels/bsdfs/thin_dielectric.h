/// A sheet of glass so thin that light goes on behind it as if it were not there.
#pragma once
#include "kernels/core/portable.h"

/// View of Material.words.
typedef struct {
    Spectrum reflection, transmission;  ///< factors of the light that is mirrored and passes, 1 in nature
} ThinDielectric;
