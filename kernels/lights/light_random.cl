// The numbers by which points of lights are chosen: functions of the way from the eye, the light and the cell, never of a lane or of the time.
#pragma once
#include "generated/time.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/morton.cl"
#include "kernels/core/random.cl"
#include "kernels/core/scene.h"

/// And, where something moves, the time at which the light is asked. Never stored.
typedef struct {
    vec2 square;  ///< a point in [0, 1)²
    uint curve;   ///< or, for what divides Morton's curve through the square, a place on it
    uint random;  ///< further numbers are hashes of it
    TIME_OF_HITS
} LightRandom;

/// For the ray with this branch; each emissive shape's cell has other numbers by its salt, in word 3. What lights of other kinds have there is all
/// one, since they ask for none.
FUNCTION LightRandom light_random(Light light, uint branch) {
    LightRandom result;
    result.random = hash(branch ^ hash(light.words[3] + 1u));
    result.square.x = unit_interval(result.random), result.square.y = unit_interval(hash(result.random + 1u));
    result.curve = hash(result.random + 1u);
    return result;
}

/// Of a point of the square that a sampler has chosen.
FUNCTION LightRandom light_random(vec2 square, uint random) {
    LightRandom result;
    result.square = square, result.random = random;
    result.curve = morton_place((uint)(int)(square.x * 0x1p16f), (uint)(int)(square.y * 0x1p16f));
    return result;
}
