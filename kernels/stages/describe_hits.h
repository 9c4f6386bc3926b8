/// What is told of a hit beside what other stages store.
#pragma once
#include "kernels/core/portable.h"

/// A surface as the stages see it, without moving its point; 80 bytes.
typedef struct {
    vec3 p;
    vec3 error;                   ///< bounds, per component, the distance from p to the true surface
    vec3 geometric;               ///< unit normal to the outside
    vec3 normal;                  ///< shading normal, unit length, to the same side
    float cosine;                 ///< between the shading normal and the way back along the ray
    float cosine_squared_beyond;  ///< of the refracted ray; negative where there is total internal reflection
    Spectrum emission;            ///< radiance
    Spectrum ambient;             ///< radiance by ambient light, before textures tint it
} HitDescription;
