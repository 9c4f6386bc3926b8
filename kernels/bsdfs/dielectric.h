/// The surface of glass, water and the like, smooth or rough: Fresnel's law divides the light at each of its facets.
#pragma once
#include "kernels/core/portable.h"

#define DIELECTRIC_LOSSES_WORD 8  ///< that of `losses`

/// View of Material.words.
typedef struct {
    Spectrum reflection, transmission;  ///< factors of the light that is mirrored and refracted, 1 in nature
    float alpha;                        ///< of the facets' distribution; 0: smooth
    uint distribution;                  ///< DISTRIBUTION_*
    uint losses;                        ///< if it is rough: words from the first of these to its LossTable, which is behind all materials
} Dielectric;
