/// How a path chooses the light that it asks at a surface.
#pragma once
#include "kernels/core/portable.h"

/// An entry of the table of aliases of SceneHeader.light_choices (Walker 1977; Vose 1991), and what is known of the light of its number. 16 bytes.
typedef struct {
    float kept;            ///< with this probability the entry means its own light,
    uint alias;            ///< else this one
    float inverse_chance;  ///< over the probability of its own light
    float radiance;        ///< of an emissive shape, mean of its channels; INFINITY for others
} LightChoice;
