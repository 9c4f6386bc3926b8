// Directions across an axis, and angles about it.
#pragma once
#include "kernels/core/lanes_1.cl"
#include "kernels/core/math.cl"

/// A direction across the axis, not of unit length.
FUNCTION vec3 across_axis(vec3 axis) {
    const bool in_xy = fabs(axis.x) > fabs(axis.z);
    return make3(in_xy ? -axis.y : 0.0f, in_xy ? axis.x : -axis.z, in_xy ? 0.0f : axis.y);
}

/// The angle of f about the axis, of unit length, counterclockwise as seen from where that leads [turns, from 0 to 1]: 1/2 along across_axis.
FUNCTION float azimuth(vec3 axis, vec3 f) {
    const vec3 x = unit(across_axis(axis));
    const vec3 y = make3(axis.y * x.z - axis.z * x.y, axis.z * x.x - axis.x * x.z, axis.x * x.y - axis.y * x.x);
    return 0.5f + INVERSE_TWO_PI * arctangent(dot3(f, y), dot3(f, x));
}
