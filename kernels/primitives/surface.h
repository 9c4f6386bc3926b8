/// Surface: what a primitive knows of a point on it; never stored.
#pragma once
#include "kernels/core/portable.h"

typedef struct {
    vec3 p;
    vec3 error;      ///< bounds, per component, the distance from p to the true surface
    vec3 geometric;  ///< unit normal to the outside
    vec3 normal;     ///< shading normal, unit length, to the same side
    vec3 lift;       ///< from p to the smooth surface that shading normals speak of, where that lies on the ray's side; else 0
} Surface;

/// Pattern: what a primitive knows of the colours at a point on it; never stored.
typedef struct {
    vec2 uv;         ///< texture coordinates
    Spectrum color;  ///< of its vertices, else white
} Pattern;
