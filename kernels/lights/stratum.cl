// Random points in a light's cells: functions of the way from the eye, the light and the cell, never of a lane or of the time.
#pragma once
#include "kernels/core/lanes_1.cl"
#include "kernels/core/random.cl"
#include "kernels/core/scene.h"
#include "kernels/lights/emission.h"

FUNCTION Emission emission_view(Light l) {
    Emission emission;
    emission.power = make3(as_float(l.words[0]), as_float(l.words[1]), as_float(l.words[2]));
    emission.stratum.salt = l.words[3], emission.stratum.rows = l.words[4], emission.stratum.column_and_row = l.words[5];
    emission.instance = l.words[6];
    return emission;
}

/// The first of a light's random numbers for the ray with this branch; the next are hashes of it.
FUNCTION uint stratum_random(Stratum stratum, uint branch) { return hash(branch ^ hash(stratum.salt + 1u)); }

/// A point in the cell, in [0, 1)² but for rounding up to 1.
FUNCTION vec2 stratum_point(Stratum stratum, uint random) {
    const float cell = 1.0f / (float)(int)stratum.rows;
    vec2 point;
    point.x = ((float)(int)(stratum.column_and_row & 0xffffu) + unit_interval(random)) * cell;
    point.y = ((float)(int)(stratum.column_and_row >> 16) + unit_interval(hash(random + 1u))) * cell;
    return point;
}
