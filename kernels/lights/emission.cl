// What a point of an emissive surface does to a point of another one.
#pragma once
#include "generated/emissive_instances.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/scene.h"
#include "kernels/lights/emission.h"
#include "kernels/lights/light.h"

/// Where the light is, at the time at which it is asked.
#define PLACE_OF_LIGHT(emission, random) PLACEMENT((emission).instance, (random).time)

FUNCTION EmissivePoint emissive_point(vec3 p, vec3 normal, float error, float inverse_density) {
    EmissivePoint point;
    point.p = p, point.normal = normal, point.error = error, point.inverse_density = inverse_density;
    return point;
}

/// Light at p in the world from a point in the space of the shape, which is in this place. The ray to it ends a little off the surface, towards p: by
/// the bound on the point's distance from the surface, and by the rounding of a ray's end, so that it cannot meet the surface. Points no further than
/// that above the surface are on it, and get nothing: flat surfaces do not light themselves, nor do round ones from outside.
FUNCTION LightSample emission_sample(Scene scene, Emission emission, Placement place, vec3 p, EmissivePoint own) {
    const EmissivePoint q = emissive_point_in_world(scene, place, p, own);
    const vec3 straight = minus(q.p, p);
    const float square = dot3(straight, straight), height = dot3(q.normal, straight);
    const float off = q.error + 0x1p-20f * (sqrt(square) + largest(absolute(q.p)));
    const vec3 way = minus(straight, scaled(q.normal, height > 0.0f ? off : -off));
    const float distance = sqrt(dot3(way, way)), inverse = 1.0f / sqrt(maximum(square, off * off));
    const uint dark = height < 0.0f ? MATERIAL_DARK_FRONT : MATERIAL_DARK_BACK;
    const float facing = fabs(height) > off ? fabs(height) * inverse : 0.0f;
    LightSample sample;
    sample.direction = scaled(straight, inverse);
    sample.ray_direction = scaled(way, 1.0f / distance);
    sample.distance = distance;
    sample.irradiance = scaled(emission.power, (emission.dark & dark) != 0u ? 0.0f : q.inverse_density * facing * inverse * inverse);
    sample.inverse_density = 0.0f;
    return sample;
}
