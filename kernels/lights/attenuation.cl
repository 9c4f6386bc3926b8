// How light from a point falls with distance.
#pragma once
#include "kernels/core/lanes_1.cl"

/// What the intensity is divided by at a distance: constant, linear and quadratic part.
FUNCTION float attenuation_at(vec3 attenuation, float distance) { return fma(fma(attenuation.z, distance, attenuation.y), distance, attenuation.x); }
