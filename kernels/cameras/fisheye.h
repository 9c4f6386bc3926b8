/// Up to all directions in a circle, whose diameter is the picture's height.
#pragma once
#include "kernels/core/portable.h"

/// View of Camera.words. The axes have unit length; the middle of the picture is in front.
typedef struct {
    vec3 forward, right, up;
    float aspect;     ///< the picture's width over its height
    float angle;      ///< between the middle and the circle [turns]: at most 1/2
    float sine;       ///< of half that angle
    float equisolid;  ///< 1: distances from the middle are as the sines of half the angles, areas as solid angles; 0: they are as the angles
} Fisheye;
