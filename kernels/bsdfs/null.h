/// A surface that is not there: light passes it straight on, whatever the medium.
#pragma once
#include "kernels/core/portable.h"

/// View of Material.words.
typedef struct {
    Spectrum transmission;  ///< factor of the light that passes
} Null;
