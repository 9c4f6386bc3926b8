// Template: crossing of a ray with a sphere, for the lane width in force.

#define SPHERE(name) sphere_##name
#include "kernels/primitives/sphere_offset.cl"

FUNCTION void sphere_box(const global SphereBlock *block, uint j, LaneBox *box) {
    const real3 center = make3(LANE(block->x, j), LANE(block->y, j), LANE(block->z, j));
    const real radius = fabs(LANE(block->radius, j));
    const real3 r = make3(radius, radius, radius);
    box->low = minus(center, r), box->high = plus(center, r);
}

/// Nearest crossing in (0, t_max]. Distance of closest approach instead of b² - ac keeps precision for small and distant spheres
/// (Haines, Günther, Akenine-Möller, Ray Tracing Gems 2019, ch. 7). Twice the digits decide on which side a ray begins.
FUNCTION Crossing sphere_crossing(const global SphereBlock *block, uint j, LaneRay ray) {
    const real3 center = make3(LANE(block->x, j), LANE(block->y, j), LANE(block->z, j));
    const real radius = LANE(block->radius, j);
    const real3 f = minus(ray.origin, center);
    const real a = dot3(ray.direction, ray.direction);
    const real b = -dot3(f, ray.direction);
    const real3 to_axis = plus(f, scaled(ray.direction, b * ray.inverse_square));
    const real discriminant = radius * radius - dot3(to_axis, to_axis);

    Crossing crossing;
    crossing.u = 0.0f, crossing.v = 0.0f, crossing.t = 0.0f;
    crossing.hit = discriminant >= 0.0f;
    if (mask_bits(crossing.hit) == 0u) return crossing;

    const real c = SPHERE(offset)(center, radius, ray.origin);
    const real q = b + copysign(sqrt(a * discriminant), b);
    const real near = minimum(c / q, q * ray.inverse_square), far = maximum(c / q, q * ray.inverse_square);
    crossing.t = where((near > 0.0f) & (radius > 0.0f), near, far);
    crossing.hit &= (crossing.t > 0.0f) & (crossing.t <= ray.t_max);
    LaneBox box;
    sphere_box(block, j, &box);
    return within_box(crossing, box, ray);
}

/// As triangle_may_meet: where it is known only by finding the crossing, it may be.
FUNCTION mask sphere_may_meet(const global SphereBlock *block, uint j, LaneRay ray, real doubt) { return ray.t_max >= 0.0f; }
#undef SPHERE
