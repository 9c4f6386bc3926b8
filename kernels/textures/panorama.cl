// Places in a picture that is all around.
#pragma once
#include "kernels/core/math.cl"

/// Where a panorama shows direction d: its middle lies along -z, its upper edge along y.
FUNCTION vec2 panorama_place(vec3 d, float turn) {
    vec2 uv;
    uv.x = 0.5f + INVERSE_TWO_PI * arctangent(d.x, -d.z) + turn;
    uv.y = 1.0f - 2.0f * INVERSE_TWO_PI * arctangent(sqrt(d.x * d.x + d.z * d.z), d.y);
    return uv;
}
