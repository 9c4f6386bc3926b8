// What a point of an emissive surface does to a point of another one.
#pragma once
#include "kernels/core/lanes_1.cl"
#include "kernels/lights/light.h"

/// Light at p from the point q of a surface with this unit normal, both of whose sides shine. `power` is the radiance over the density with which q
/// was chosen [1/area]. The light is a little off the surface, towards p: by `error`, the bound on q's distance from the surface, and by the
/// rounding of a ray's end, so that a ray to it cannot meet the surface.
FUNCTION LightSample emission_sample(vec3 p, vec3 q, vec3 normal, float error, Spectrum power) {
    const vec3 straight = minus(q, p);
    const float square = dot3(straight, straight);
    const float rounding = 0x1p-20f * (sqrt(square) + largest(absolute(q)));
    const float off = error + rounding;
    const vec3 way = minus(straight, scaled(normal, dot3(normal, straight) > 0.0f ? off : -off));
    const float distance = sqrt(dot3(way, way));
    LightSample sample;
    sample.direction = scaled(way, 1.0f / distance);
    sample.distance = distance;
    sample.irradiance = scaled(power, fabs(dot3(normal, sample.direction)) / (distance * distance));
    return sample;
}
