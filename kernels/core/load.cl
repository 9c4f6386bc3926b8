// Records from global memory, field by field: a copy of a whole struct becomes loads of vectors of two floats, which keep the compiler from
// making a loop over items 16 wide.
#pragma once
#include "kernels/core/items.h"
#include "kernels/core/lanes_1.cl"

FUNCTION vec3 load(const global vec3 *p) { return make3(p->x, p->y, p->z); }

FUNCTION Ray load(const global Ray *p) {
    Ray ray;
    ray.origin = load(&p->origin), ray.direction = load(&p->direction);
    ray.t_max = p->t_max, ray.tag = p->tag;
    return ray;
}

FUNCTION Hit load(const global Hit *p) {
    Hit hit;
    hit.t = p->t, hit.primitive = p->primitive, hit.u = p->u, hit.v = p->v;
    return hit;
}

FUNCTION Path load(const global Path *p) {
    Path path;
    path.throughput = load(&p->throughput);
    path.slot = p->slot, path.branch = p->branch, path.depth = p->depth;
    return path;
}

FUNCTION SurfacePoint load(const global SurfacePoint *p) {
    SurfacePoint point;
    point.origin = load(&p->origin), point.normal = load(&p->normal);
    point.material = p->material, point.flags = p->flags;
    return point;
}

FUNCTION SurfaceInterface load(const global SurfaceInterface *p) {
    SurfaceInterface interface;
    interface.geometric = load(&p->geometric), interface.eta = p->eta, interface.beyond = load(&p->beyond);
    return interface;
}

/// Three words at w as floats.
FUNCTION vec3 load_floats(const uint *w) { return make3(as_float(w[0]), as_float(w[1]), as_float(w[2])); }
FUNCTION vec3 load_floats(const global uint *w) { return make3(as_float(w[0]), as_float(w[1]), as_float(w[2])); }
