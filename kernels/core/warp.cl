// From the unit square to other shapes.
#pragma once
#include "kernels/core/math.cl"

/// Uniform on the unit disk.
FUNCTION vec2 uniform_on_disk(vec2 u) {
    const float radius = sqrt(u.x);
    vec2 p = turn(u.y);
    p.x *= radius, p.y *= radius;
    return p;
}

/// The same, where squares around the middle become disks, and strata stay compact (Shirley & Chiu, Journal of Graphics Tools 2(3) 1997).
FUNCTION vec2 concentric_disk(vec2 u) {
    const float a = 2.0f * u.x - 1.0f, b = 2.0f * u.y - 1.0f;
    const bool wide = fabs(a) > fabs(b);
    const float radius = wide ? a : b, other = wide ? b : a, eighths = other / (radius == 0.0f ? 1.0f : radius);
    vec2 p = turn(wide ? 0.125f * eighths : 0.25f - 0.125f * eighths);
    p.x *= radius, p.y *= radius;
    return p;
}

/// On the hemisphere above z = 0, with density cosine / π.
FUNCTION vec3 cosine_hemisphere(vec2 u) {
    const vec2 p = uniform_on_disk(u);
    return make3(p.x, p.y, sqrt(maximum(1.0f - u.x, 0.0f)));
}

/// The square is folded onto the triangle, so that neighbours stay neighbours (Heitz, A Low-Distortion Map Between Triangle and Square, 2019).
FUNCTION vec2 triangle_of_square(vec2 square) {
    const bool above = square.y > square.x;
    const float half_x = 0.5f * square.x, half_y = 0.5f * square.y;
    vec2 point;
    point.x = above ? half_x : square.x - half_y;
    point.y = above ? square.y - half_x : half_y;
    return point;
}

/// Cosine of the angle to an axis, of directions around it with density (n + 1) / 2π cosine^n.
FUNCTION float power_cosine(float u, float exponent) { return power(1.0f - u, 1.0f / (exponent + 1.0f)); }
