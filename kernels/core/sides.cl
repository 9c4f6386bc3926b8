// Both sides of a surface, as a ray that comes from one of them finds them.
#pragma once
#include "kernels/core/items.h"
#include "kernels/core/lanes_1.cl"

/// `v`, or its mirror image at the plane of `normal`, whichever is on the normal's side.
FUNCTION vec3 folded(vec3 v, vec3 normal) { return plus(v, scaled(normal, maximum(-2.0f * dot3(v, normal), 0.0f))); }

/// Never stored.
typedef struct {
    vec3 normal, geometric;  ///< of shading and of the surface, on the side that the ray comes from
    vec3 near, far;          ///< the point moved off to that side, and to the other
} Sides;

FUNCTION Sides sides_of(SurfacePoint surface, SurfaceInterface interface) {
    const bool lit_beyond = (surface.flags & SURFACE_LIT_BEYOND) != 0u;
    const float side = lit_beyond ? -1.0f : 1.0f;
    Sides sides;
    sides.normal = scaled(surface.normal, side), sides.geometric = scaled(interface.geometric, side);
    sides.near = where(lit_beyond, interface.beyond, surface.origin), sides.far = where(lit_beyond, surface.origin, interface.beyond);
    return sides;
}
