// Points in a light's cells.
#pragma once
#include "kernels/core/lanes_1.cl"
#include "kernels/core/random.cl"
#include "kernels/core/scene.h"
#include "kernels/lights/emission.h"
#include "kernels/lights/light_random.cl"

FUNCTION Emission emission_view(Light l) {
    Emission emission;
    emission.power = make3(as_float(l.words[0]), as_float(l.words[1]), as_float(l.words[2]));
    emission.stratum.salt = l.words[3], emission.stratum.cell = l.words[4];
    emission.instance = l.words[5], emission.dark = l.words[6];
    return emission;
}

/// A point in the cell, in [0, 1)² but for rounding up to 1.
FUNCTION vec2 stratum_point(Stratum stratum, LightRandom random) {
    const float cell = 1.0f / (float)(int)(stratum.cell >> 16);
    vec2 point;
    point.x = ((float)(int)(stratum.cell & 0xffu) + random.square.x) * cell;
    point.y = ((float)(int)(stratum.cell >> 8 & 0xffu) + random.square.y) * cell;
    return point;
}
