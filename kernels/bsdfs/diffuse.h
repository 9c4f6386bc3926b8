/// A surface that looks equally bright from everywhere (Lambert).
#pragma once
#include "kernels/core/portable.h"

/// View of Material.words.
typedef struct {
    Spectrum reflectance;
} Diffuse;
