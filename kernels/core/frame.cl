// Directions around an axis.
#pragma once
#include "kernels/core/lanes_1.cl"

/// Unit vectors across each other, axis = right × up.
typedef struct {
    vec3 right, up, axis;
} Frame;

/// Around a unit vector (Duff et al., JCGT 6(1) 2017).
FUNCTION Frame frame_of(vec3 axis) {
    const float sign = copysign(1.0f, axis.z), a = -1.0f / (sign + axis.z), b = axis.x * axis.y * a;
    Frame frame;
    frame.right = make3(fma(sign * axis.x, axis.x * a, 1.0f), sign * b, -sign * axis.x);
    frame.up = make3(b, fma(axis.y, axis.y * a, sign), -axis.y);
    frame.axis = axis;
    return frame;
}

FUNCTION vec3 to_frame(Frame frame, vec3 v) { return make3(dot3(v, frame.right), dot3(v, frame.up), dot3(v, frame.axis)); }
FUNCTION vec3 from_frame(Frame frame, vec3 v) { return plus(scaled(frame.axis, v.z), plus(scaled(frame.right, v.x), scaled(frame.up, v.y))); }

/// The vector whose component along the unit vector `axis` is z, across it `radius`, and whose azimuth about it has this cosine (x) and sine (y).
FUNCTION vec3 from_axis(vec3 axis, float z, float radius, vec2 azimuth) {
    return from_frame(frame_of(axis), make3(radius * azimuth.x, radius * azimuth.y, z));
}
/// The unit vector.
FUNCTION vec3 from_axis(vec3 axis, float z, vec2 azimuth) { return from_axis(axis, z, sqrt(maximum((1.0f - z) * (1.0f + z), 0.0f)), azimuth); }
