// Emissive sphere: from outside points of the part that is seen, from inside all points.
#pragma once
#include "kernels/core/frame.cl"
#include "kernels/core/math.cl"
#include "kernels/core/scene.cl"
#include "kernels/lights/emission.cl"
#include "kernels/lights/stratum.cl"

#define SPHERE(name) emissive_sphere_##name
#include "kernels/primitives/sphere_offset.cl"
#undef SPHERE

FUNCTION EmissiveSphere emissive_sphere_view(Light l) {
    EmissiveSphere light;
    light.emission = emission_view(l);
    light.center = make3(as_float(l.words[7]), as_float(l.words[8]), as_float(l.words[9]));
    light.radius = as_float(l.words[10]);
    return light;
}

/// Where the axis is z and points to p, at distance d from the centre: from outside z² is uniform between (radius / d)², the horizon, and 1, so that
/// the density [1/area] is z / (pi radius² (1 - (radius / d)²)), which from afar makes every point count the same; from inside z is uniform
/// between -1 and 1, and the density 1 / (4 pi radius²). However near p is, 1 - (radius / d)² and 1 - z² have their digits.
FUNCTION LightSample emissive_sphere_sample(Scene scene, Light l, vec3 world_p, LightRandom random) {
    const EmissiveSphere light = emissive_sphere_view(l);
    const Placement place = PLACE_OF_LIGHT(light.emission, random);
    const vec3 p = lit_point_in_group(scene, place, world_p);
    const vec2 square = stratum_point(light.emission.stratum, random);
    const float offset = emissive_sphere_offset(light.center, light.radius, p);
    const bool outside = offset > 0.0f;
    const vec3 f = minus(p, light.center);
    const float square_d = dot3(f, f), d = sqrt(square_d), seen = offset / square_d;
    const float z = outside ? sqrt(maximum(fma(-seen, square.x, 1.0f), 0x1p-48f)) : 1.0f - 2.0f * square.x;
    const float sine = sqrt(outside ? seen * square.x : 4.0f * square.x * maximum(1.0f - square.x, 0.0f));
    const float inverse_density = (outside ? seen / z : 4.0f) * PI * light.radius * light.radius;

    const vec3 axis = where(d > 0.0f, scaled(f, 1.0f / d), make3(0.0f, 0.0f, 1.0f));
    const vec3 normal = unit(from_axis(axis, z, sine, turn(square.y)));
    const vec3 q = plus(light.center, scaled(normal, light.radius));
    const float error = 0x1p-21f * (largest(absolute(light.center)) + light.radius);
    return emission_sample(scene, light.emission, place, world_p, emissive_point(q, normal, error, inverse_density));
}
