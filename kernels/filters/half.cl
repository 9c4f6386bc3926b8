// What symmetric filters share: a random number chooses a side, and how much of the filter's mass lies further out.
#pragma once
#include "kernels/core/lanes_1.cl"

/// That part of the mass, without rounding: from 1 at the centre, u = 1/2, to 0 at both ends.
FUNCTION float mass_beyond(float u) { return 2.0f * minimum(u, 1.0f - u); }

/// From the pixel's left or upper edge [pixels], on the side of u.
FUNCTION float place_at(float u, float distance) { return 0.5f + (u < 0.5f ? -distance : distance); }
