/// What is told of a path at the end of its ray beside what other stages store. Of what is weighted, throughput is as if it were 1.
#pragma once
#include "kernels/core/items.h"
#include "kernels/core/portable.h"

// Why a path does not go on.
#define PATH_ABSORBED 1u  ///< the surface sends nothing there
#define PATH_ACROSS 2u    ///< the direction leads to one side of the surface, and to the other of its shading normal's plane
#define PATH_ENDED 4u     ///< by chance
#define PATH_NO_PART 8u   ///< the surface's bundle has fewer parts

/// What shines where the ray ends, or the background; 16 bytes.
typedef struct {
    Spectrum radiance;
    float weight;  ///< by the power heuristic
} MetDescription;

/// How a path goes on from there; 72 bytes.
typedef struct {
    Ray ray;
    Spectrum weight;     ///< throughput behind the surface
    Spectrum scattered;  ///< the BSDF's value times the cosine over the density
    float pdf;           ///< density with which the BSDF chose the direction [1/sr]; INFINITY where it is one of single ones
    float survival;      ///< chance that the path goes on,
    float roulette;      ///< which is so where this, in [0, 1), is below it
    uint refusals;       ///< PATH_...: all that speaks against it
} NextDescription;

/// The light that it has asked there; 60 bytes.
typedef struct {
    uint row;               ///< of the scene's lights
    float chance;           ///< that it is chosen
    Spectrum irradiance;    ///< on a surface there that faces it
    float inverse_density;  ///< over the density with which its direction is chosen, among all lights [sr]; 0: it has no size
    float cosine;           ///< between the shading normal and the way to it
    Spectrum value;         ///< the BSDF times the cosine [1/sr]
    float pdf;              ///< density with which the BSDF would have chosen the direction [1/sr]
    float weight;           ///< by the power heuristic
    Spectrum radiance;      ///< back along the ray
    uint refusals;          ///< LIGHT_...: all that speaks against asking
} AskedDescription;
