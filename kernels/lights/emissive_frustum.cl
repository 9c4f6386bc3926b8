// Emissive cone or cylinder: points uniform by area.
#pragma once
#include "kernels/core/frame.cl"
#include "kernels/core/math.cl"
#include "kernels/core/scene.cl"
#include "kernels/lights/emission.cl"
#include "kernels/lights/stratum.cl"

FUNCTION EmissiveFrustum emissive_frustum_view(Light l) {
    EmissiveFrustum light;
    light.emission = emission_view(l);
    light.center = make3(as_float(l.words[7]), as_float(l.words[8]), as_float(l.words[9]));
    light.along = make3(as_float(l.words[10]), as_float(l.words[11]), as_float(l.words[12]));
    light.radius = as_float(l.words[13]), light.rise = as_float(l.words[14]);
    return light;
}

/// The squared radius is uniform between those of both ends, a and b: at its root r the part (r - a) / (b - a) = u (a + b) / (a + r) of the length
/// lies behind.
FUNCTION LightSample emissive_frustum_sample(Scene scene, Light l, vec3 p, LightRandom random) {
    const EmissiveFrustum light = emissive_frustum_view(l);
    const vec2 square = stratum_point(light.emission.stratum, random);
    const float a = light.radius - light.rise, b = light.radius + light.rise;
    const float r = sqrt(fma(square.x, (b - a) * (b + a), a * a));
    const float part = square.x * (a + b) / maximum(a + r, 0x1p-126f), z = 2.0f * part - 1.0f;

    const float half_length = sqrt(dot3(light.along, light.along));
    const vec3 axis = scaled(light.along, 1.0f / half_length);
    const vec3 outward = unit(from_axis(axis, 0.0f, turn(square.y)));
    const float radius = maximum(fma(light.rise, z, light.radius), 0.0f);
    const vec3 q = plus(light.center, plus(scaled(light.along, z), scaled(outward, radius)));
    const vec3 normal = unit(minus(scaled(outward, half_length), scaled(axis, light.rise)));
    const float error = 0x1p-20f * (largest(absolute(light.center)) + half_length + light.radius + fabs(light.rise));
    return emission_sample(scene, light.emission, PLACE_OF_LIGHT(light.emission, random), p, emissive_point(q, normal, error, 1.0f));
}
