// Axis of the largest component of a direction.
#pragma once
#include "kernels/core/lanes_1.cl"

FUNCTION uint major_axis(vec3 d) {
    const float x = fabs(d.x), y = fabs(d.y), z = fabs(d.z);
    return ((x >= y) & (x >= z)) ? 0u : y >= z ? 1u : 2u;
}
