/// Faces that rays go straight through, told when a pixel is inspected.
#pragma once
#include "kernels/core/items.h"

/// 48 bytes.
typedef struct {
    vec3 p;                 ///< where
    uint enters;            ///< 1 if the ray enters something there, 0 if it leaves it
    Hit hit;                ///< t is that of p on the ray as spawned
    Spectrum transmission;  ///< of the light, where the ray is a shadow ray: 0 of what is opaque; of others 1
    uint instance;          ///< that the face is in, 0 outside of all
} PassedFace;
