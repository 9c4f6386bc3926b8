/// What a light does to a point; never stored.
#pragma once
#include "kernels/core/portable.h"

// Why a surface does not ask whether a light is visible.
#define LIGHT_NOT_SHOWN 1u       ///< nothing is hit, or no light of lights is seen on it
#define LIGHT_BEHIND 2u          ///< it does not face the shading normal
#define LIGHT_SENDS_NOTHING 4u   ///< there
#define LIGHT_ACROSS 8u          ///< of paths: it is on one side of the surface, and on the other of its shading normal's plane
#define LIGHT_NOT_SCATTERED 16u  ///< of paths: the material sends none of it back along the ray

typedef struct {
    vec3 direction;       ///< from the point towards the light, unit length
    vec3 ray_direction;   ///< the same, but for what keeps a ray off a surface that shines
    float distance;       ///< at which a ray in that direction ends, infinite for directional lights
    Spectrum irradiance;  ///< on a surface at the point that faces the light [W/m²]
    /// Of the environment, over the density with which the direction was chosen [sr]; 0 of other lights, whose irradiance tells theirs.
    float inverse_density;
} LightSample;
