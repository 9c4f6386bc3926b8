// Transforms from global memory.
#pragma once
#include "kernels/core/load.cl"
#include "kernels/primitives/transform.h"

FUNCTION Transform load(const global Transform *p) {
    Transform m;
    m.x = load(&p->x), m.y = load(&p->y), m.z = load(&p->z), m.origin = load(&p->origin);
    return m;
}
