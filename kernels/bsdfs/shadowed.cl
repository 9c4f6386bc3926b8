// Directions of light that leaves rough surfaces after several facets: those in which facets hide each other.
#pragma once
#include "kernels/bsdfs/bsdf.h"
#include "kernels/core/math.cl"

/// Density by which they are chosen, above the surface [1/sr]. Losses by shadows are about as b / (b + z²), of mirrors of b = alpha².
FUNCTION float shadowed_density(float b, float z) { return INVERSE_PI * z / (fma(z, z, b) * logarithm(1.0f + 1.0f / b)); }

FUNCTION vec3 shadowed_direction(float b, vec2 u) {
    const float z2 = minimum(maximum(b * (power(1.0f + 1.0f / b, u.x) - 1.0f), 0.0f), 1.0f), radius = sqrt(1.0f - z2);
    const vec2 azimuth = turn(u.y);
    return make3(radius * azimuth.x, radius * azimuth.y, sqrt(z2));
}
