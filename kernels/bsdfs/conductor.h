/// Metal.
#pragma once
#include "kernels/bsdfs/albedo_curve.h"
#include "kernels/core/portable.h"

/// View of Material.words.
typedef struct {
    Spectrum eta, k;     ///< index of refraction eta + i k, over that of what surrounds it
    Spectrum specular;   ///< factor of all that is reflected
    Spectrum multiple;   ///< light that facets reflect onto each other, over both directions' losses [1/sr]
    float alpha;         ///< roughness of its facets; 0: an ideal mirror
    uint distribution;   ///< of their normals, DISTRIBUTION_*
    AlbedoCurve albedo;  ///< of facets that reflect everything
} Conductor;
