// Directions around an axis.
#pragma once
#include "kernels/core/lanes_1.cl"

/// The unit vector whose component along the unit vector `axis` is z and whose azimuth about it has this cosine (x) and sine (y). The frame's other
/// axes are those of Duff et al. (JCGT 6(1) 2017).
FUNCTION vec3 from_axis(vec3 axis, float z, vec2 azimuth) {
    const float sign = copysign(1.0f, axis.z), a = -1.0f / (sign + axis.z), b = axis.x * axis.y * a;
    const vec3 right = make3(fma(sign * axis.x, axis.x * a, 1.0f), sign * b, -sign * axis.x);
    const vec3 up = make3(b, fma(axis.y, axis.y * a, sign), -axis.y);
    const float radius = sqrt(maximum((1.0f - z) * (1.0f + z), 0.0f));
    return plus(scaled(axis, z), plus(scaled(right, radius * azimuth.x), scaled(up, radius * azimuth.y)));
}
