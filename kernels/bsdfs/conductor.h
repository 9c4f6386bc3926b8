/// Metal.
#pragma once
#include "kernels/bsdfs/angle_curve.h"
#include "kernels/core/portable.h"

#define CONDUCTOR_LOST_WORD 14  ///< where `lost` begins

/// View of Material.words.
typedef struct {
    Spectrum eta, k;    ///< index of refraction eta + i k, over that of what surrounds it
    Spectrum specular;  ///< factor of all that is reflected
    Spectrum multiple;  ///< light that facets reflect onto each other, over both directions' losses [1/sr]
    float alpha;        ///< roughness of its facets; 0: an ideal mirror
    uint distribution;  ///< of their normals, DISTRIBUTION_*
    AngleCurve lost;    ///< root of the part of light that facets do not reflect at once, though they reflect everything
} Conductor;
