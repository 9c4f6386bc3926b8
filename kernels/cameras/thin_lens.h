/// A lens without thickness, which makes what lies in one plane sharp.
#pragma once
#include "kernels/core/portable.h"

/// View of Camera.words. All rays through picture point (x, y) in [0, 1]², from the top left, meet at position + corner + x right + y down, in the
/// sharp plane; they begin at position + u across + v along, (u, v) being in the unit disk.
typedef struct {
    vec3 corner, right, down;
    vec3 across, along;  ///< radii of the lens, to the right and upwards
    float blades;        ///< of the aperture: the corners of a regular polygon, whose circle the lens is; 0: it is round
    float turned;        ///< angle of the first corner from `across` towards `along` [turns, from 0 to 1]
} ThinLens;
