// Template: crossing of a ray with the lateral surface of a frustum, for the lane width in force.

FUNCTION void frustum_box(const global FrustumBlock *block, uint j, LaneBox *box) {
    box->low = make3(LANE(block->low[0], j), LANE(block->low[1], j), LANE(block->low[2], j));
    box->high = make3(LANE(block->high[0], j), LANE(block->high[1], j), LANE(block->high[2], j));
}

/// Nearest crossing in (0, t_max] with the part |z| <= half_length of x² = (radius + slope z)². The quadratic is set up at the point of the
/// ray nearest to the frustum's centre, and its discriminant by exact products, so that distance costs no precision.
/// A ray that begins on the surface, within rounding, does not meet it there. Its box is tested first: most rays miss it.
FUNCTION Crossing frustum_crossing(const global FrustumBlock *block, uint j, LaneRay ray) {
    Crossing crossing;
    crossing.t = 0.0f, crossing.u = 0.0f, crossing.v = 0.0f;
    crossing.hit = (crossing.t == 0.0f);
    LaneBox box;
    frustum_box(block, j, &box);
    crossing = within_box(crossing, box, ray);
    if (mask_bits(crossing.hit) == 0u) return crossing;
    const real entry = crossing.t;

    const real3 center = make3(LANE(block->center[0], j), LANE(block->center[1], j), LANE(block->center[2], j));
    const real3 axis = make3(LANE(block->axis[0], j), LANE(block->axis[1], j), LANE(block->axis[2], j));
    const real radius = LANE(block->radius, j), slope = LANE(block->slope, j), half_length = LANE(block->half_length, j);

    const real3 f = minus(ray.origin, center);
    const real nearest = -dot3(f, ray.direction) * ray.inverse_square;
    const real3 m = plus(f, scaled(ray.direction, nearest));
    const real dz = dot3(ray.direction, axis), mz = dot3(m, axis);
    const real3 d = minus(ray.direction, scaled(axis, dz)), x = minus(m, scaled(axis, mz));
    const real r = fma(slope, mz, radius), dr = slope * dz;
    const real a = dot3(d, d) - dr * dr;
    const real b = dot3(x, d) - dr * r;
    const real c = dot3(x, x) - r * r;
    const real discriminant = difference_of_products(b, b, a, c);

    crossing.hit &= discriminant >= 0.0f;
    if (mask_bits(crossing.hit) == 0u) return crossing;

    const real q = -(b + copysign(sqrt(discriminant), b));
    const real s0 = q / a, s1 = c / q;
    const real z0 = fma(s0, dz, mz), z1 = fma(s1, dz, mz);
    real t0 = nearest + s0, t1 = nearest + s1;

    const real fz = dot3(f, axis), fr = fma(slope, fz, radius);
    const real3 fx = minus(f, scaled(axis, fz));
    const real width = fabs(fr) + fabs(r) + sqrt(dot3(x, x));  // near the tip the coefficients' rounding is that of the wider place at m
    const mask starts_on = fabs(dot3(fx, fx) - fr * fr) <= 0x1p-20f * width * (width + fabs(fz) + fabs(mz));
    const mask first_is_start = fabs(t0) < fabs(t1);
    // The surface's gradient along the ray tells whether a crossing is seen from outside.
    const real side = LANE(block->side, j);
    const mask faces0 = (side > 0.0f) | (fma(a, s0, b) > 0.0f), faces1 = (side > 0.0f) | (fma(a, s1, b) > 0.0f);
    const mask in0 = (fabs(z0) <= half_length) & (fma(slope, z0, radius) >= 0.0f) & (t0 > 0.0f) & !(starts_on & first_is_start) & faces0;
    const mask in1 = (fabs(z1) <= half_length) & (fma(slope, z1, radius) >= 0.0f) & (t1 > 0.0f) & !(starts_on & !first_is_start) & faces1;
    crossing.t = maximum(where(in0 & (!in1 | (t0 < t1)), t0, t1), entry);
    crossing.hit &= (in0 | in1) & (crossing.t <= ray.t_max);
    return crossing;
}

/// As triangle_may_meet: where it is known only by finding the crossing, it may be.
FUNCTION mask frustum_may_meet(const global FrustumBlock *block, uint j, LaneRay ray, real doubt) { return ray.t_max >= 0.0f; }
