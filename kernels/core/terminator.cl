// Where light ends on triangles with shading normals.
#pragma once
#include "kernels/core/lanes_1.cl"

/// In [0, 1]: what is left of light that comes from `direction` above the shading normal's plane. Below the surface's own plane it is 0, towards
/// which it falls smoothly, so that no triangle has an edge of light; far above both planes it is 1, and so it is where the normals are the same
/// (Chiang, Li & Burley, Taming the Shadow Terminator, SIGGRAPH Talks 2019). All are unit vectors, `normal` and `geometric` on one side.
FUNCTION float terminator_factor(vec3 normal, vec3 geometric, vec3 direction) {
    const float plain = dot3(normal, direction) * dot3(normal, geometric);
    const float g = minimum(maximum(dot3(geometric, direction) / plain, 0.0f), 1.0f);
    return plain > 0.0f ? g * fma(g, 1.0f - g, 1.0f) : 0.0f;
}
