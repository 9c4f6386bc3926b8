/// Spot light: a point light that shines into a cone.
#pragma once
#include "kernels/core/portable.h"

/// View of Light.words. At distance d, in a direction at angle a from the axis, it gives intensity * f / (attenuation.x + attenuation.y d +
/// attenuation.z d²), where f = s² (3 - 2 s) of s = (edge - (1 - cos a)) * steepness, cut to [0, 1].
typedef struct {
    vec3 position;
    vec3 direction;      ///< of the cone's axis, unit length
    Spectrum intensity;  ///< on the axis [W/sr]
    vec3 attenuation;
    float edge;       ///< 1 - cosine of half the cone's angle; a cosine near 1 alone would have lost its digits
    float steepness;  ///< 1 / (edge - the same of the cone in which the intensity is full)
} SpotLight;
