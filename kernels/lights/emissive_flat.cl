// Emissive face of a mesh: points uniform by area.
#pragma once
#include "kernels/core/scene.cl"
#include "kernels/core/warp.cl"
#include "kernels/lights/emission.cl"
#include "kernels/lights/light_random.cl"

FUNCTION EmissiveFlat emissive_flat_view(Light l) {
    EmissiveFlat light;
    light.power = make3(as_float(l.words[0]), as_float(l.words[1]), as_float(l.words[2])), light.folded = l.words[3];
    light.corner = make3(as_float(l.words[4]), as_float(l.words[5]), as_float(l.words[6]));
    light.u = make3(as_float(l.words[7]), as_float(l.words[8]), as_float(l.words[9]));
    light.v = make3(as_float(l.words[10]), as_float(l.words[11]), as_float(l.words[12]));
    light.instance = l.words[13], light.dark = l.words[14];
    return light;
}

/// The point's rounding error is at most 2^-22 of the lengths that it is made of, and the fourth corner of a parallelogram may be off by as much.
FUNCTION LightSample emissive_flat_sample(Scene scene, Light l, vec3 p, LightRandom random) {
    const EmissiveFlat light = emissive_flat_view(l);
    const vec2 folded = triangle_of_square(random.square);
    const float s = light.folded != 0u ? folded.x : random.square.x, t = light.folded != 0u ? folded.y : random.square.y;
    const vec3 q = plus(light.corner, plus(scaled(light.u, s), scaled(light.v, t)));
    const vec3 across = cross3(light.u, light.v);
    const vec3 normal = unit(scaled(across, 1.0f / largest(absolute(across))));  // squares of small ones underflow
    const float error = 0x1p-20f * largest(plus(absolute(light.corner), plus(absolute(light.u), absolute(light.v))));
    Emission emission;
    emission.power = light.power, emission.instance = light.instance, emission.dark = light.dark;
    emission.stratum.salt = 0u, emission.stratum.cell = 0u;
    return emission_sample(scene, emission, PLACE_OF_LIGHT(emission, random), p, emissive_point(q, normal, error, 1.0f));
}
