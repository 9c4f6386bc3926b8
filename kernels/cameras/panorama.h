/// All around: the picture's columns are longitudes, its rows latitudes (equirectangular).
#pragma once
#include "kernels/core/portable.h"

/// View of Camera.words. The axes have unit length; the middle of the picture is in front.
typedef struct {
    vec3 forward, right, up;
    float width, height;  ///< angles between the picture's edges [turns]: at most 1 and 1/2
} Panorama;
