/// A diffuse base under a clear coat.
#pragma once
#include "kernels/bsdfs/angle_curve.h"
#include "kernels/core/portable.h"

#define PLASTIC_COAT_WORD 9  ///< where `coat` begins

/// View of Material.words.
typedef struct {
    Spectrum diffuse;   ///< reflectance of the base
    float eta;          ///< index of refraction of what surrounds the coat over that of the coat
    float internal;     ///< part of diffuse light from below that the coat's boundary reflects
    float scale;        ///< 1 / π over the part of diffuse light from above that the boundary lets through
    float alpha;        ///< roughness of the coat; 0: smooth
    uint distribution;  ///< of its facets' normals, DISTRIBUTION_*
    uint nonlinear;     ///< 1: colours become deeper by reflection within the coat
    AngleCurve coat;    ///< part of light that the coat reflects at once, over that of a smooth one
} Plastic;
