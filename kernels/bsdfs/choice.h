/// Materials that stand for others, of which one counts at every hit.
#pragma once
#include "kernels/core/portable.h"

/// View of Material.words of materials with MATERIAL_CHOOSES.
typedef struct {
    uint members[2];  ///< numbers of materials, which may choose in turn; in scenes NO_MATERIAL stands for one that lets all light pass
    uint by_side;     ///< 1: the first where a ray meets the outside, else the second; 0: by chance
    Spectrum amount;  ///< the mean of it, times the material's diffuse_texture, is the chance of the second
} Choice;
