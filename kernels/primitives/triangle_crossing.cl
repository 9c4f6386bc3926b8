// Template: crossing of a ray with a triangle, for the lane width in force, as functions TRIANGLE(name).

FUNCTION void TRIANGLE(vertices)(const global TriangleBlock *block, uint j, real3 *a, real3 *b, real3 *c) {
    *a = make3(LANE(block->a[0], j), LANE(block->a[1], j), LANE(block->a[2], j));
    *b = make3(LANE(block->b[0], j), LANE(block->b[1], j), LANE(block->b[2], j));
    *c = make3(LANE(block->c[0], j), LANE(block->c[1], j), LANE(block->c[2], j));
}

FUNCTION void TRIANGLE(box)(const global TriangleBlock *block, uint j, LaneBox *box) {
    real3 a, b, c;
    TRIANGLE(vertices)(block, j, &a, &b, &c);
    box->low = minimum(a, minimum(b, c)), box->high = maximum(a, maximum(b, c));
}

/// Whether the origin may be in the triangle with these corners. Rounding is monotone: a rounded product that is less than another says that the
/// exact one is, so nothing is rejected that the exact signs would not reject (Woop et al. section 3.1).
FUNCTION mask TRIANGLE(may_cross)(real ax, real ay, real bx, real by, real cx, real cy) {
    const real u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
    const mask left = minimum(u, minimum(v, w)) >= 0.0f, right = maximum(u, maximum(v, w)) <= 0.0f;
    return left | right;
}

/// Whether a ray may cross it, by few operations: false only where TRIANGLE(crossing) finds no crossing. The signs are those of may_cross, for which
/// it has the same vertices; t times the determinant is known but for `doubt`, as ray_doubt gives it. What is not a number is not left out.
FUNCTION mask TRIANGLE(may_meet)(const global TriangleBlock *block, uint j, LaneRay ray, real doubt) {
    const real ox = ray.turned_origin.x, oy = ray.turned_origin.y, oz = ray.turned_origin.z;
    const real az = LANE(block->a[ray.kz], j) - oz, bz = LANE(block->b[ray.kz], j) - oz, cz = LANE(block->c[ray.kz], j) - oz;
    const real ax = fma(-ray.shear.x, az, LANE(block->a[ray.kx], j) - ox), ay = fma(-ray.shear.y, az, LANE(block->a[ray.ky], j) - oy);
    const real bx = fma(-ray.shear.x, bz, LANE(block->b[ray.kx], j) - ox), by = fma(-ray.shear.y, bz, LANE(block->b[ray.ky], j) - oy);
    const real cx = fma(-ray.shear.x, cz, LANE(block->c[ray.kx], j) - ox), cy = fma(-ray.shear.y, cz, LANE(block->c[ray.ky], j) - oy);
    const real u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
    const real det = u + v + w;
    const mask sign = REAL_BITS(det) & (mask)((int)0x80000000);
    const real su = BITS_REAL(REAL_BITS(u) ^ sign), sv = BITS_REAL(REAL_BITS(v) ^ sign), sw = BITS_REAL(REAL_BITS(w) ^ sign);
    const real t = fma(su, az, fma(sv, bz, sw * cz)) * ray.shear.z;
    return (LANE_NUMBER(block->primitive, j) != ray.source) & !(minimum(su, minimum(sv, sw)) < 0.0f) & !(t < -doubt) &
           !(t > fma(ray.t_max, fabs(det), doubt));
}

/// The value's sign; where it is 0, the origin being on the edge from p to q, the sign for an origin moved by (e, e^2), e > 0 as small as it takes
/// (Edelsbrunner, Mücke, ACM TOG 9(1) 1990). Triangles that share the edge see it in opposite directions and find opposite signs.
FUNCTION real TRIANGLE(side)(real value, real px, real py, real qx, real qy) {
    const real moved = where(qy != py, qy - py, px - qx);
    return where(value != 0.0f, value, moved);
}

/// Watertight (Woop, Benthin, Wald, JCGT 2(1) 2013): the signs of the edge functions are exact for the sheared vertices, and a ray through an edge
/// or a vertex crosses the triangles round it as one right beside it would: one of two that continue each other, both or none at an outline.
/// Both sides count. u, v are the weights of vertices b and c.
/// Where rounding could decide on which side of the plane the ray begins, offsets of twice the digits do, however large the triangle is.
FUNCTION Crossing TRIANGLE(crossing)(const global TriangleBlock *block, uint j, LaneRay ray) {
    const real ox = ray.turned_origin.x, oy = ray.turned_origin.y, oz = ray.turned_origin.z;
    const real az = LANE(block->a[ray.kz], j) - oz, bz = LANE(block->b[ray.kz], j) - oz, cz = LANE(block->c[ray.kz], j) - oz;
    const real ax = fma(-ray.shear.x, az, LANE(block->a[ray.kx], j) - ox), ay = fma(-ray.shear.y, az, LANE(block->a[ray.ky], j) - oy);
    const real bx = fma(-ray.shear.x, bz, LANE(block->b[ray.kx], j) - ox), by = fma(-ray.shear.y, bz, LANE(block->b[ray.ky], j) - oy);
    const real cx = fma(-ray.shear.x, cz, LANE(block->c[ray.kx], j) - ox), cy = fma(-ray.shear.y, cz, LANE(block->c[ray.ky], j) - oy);
    Crossing crossing;
    crossing.t = 0.0f, crossing.u = 0.0f, crossing.v = 0.0f;
    crossing.hit = (LANE_NUMBER(block->primitive, j) != ray.source) & TRIANGLE(may_cross)(ax, ay, bx, by, cx, cy);
    if (mask_bits(crossing.hit) == 0u) return crossing;

    const real u = difference_of_products(cx, by, cy, bx);
    const real v = difference_of_products(ax, cy, ay, cx);
    const real w = difference_of_products(bx, ay, by, ax);
    const real det = u + v + w;

    crossing.hit &= (((u >= 0.0f) & (v >= 0.0f) & (w >= 0.0f)) | ((u <= 0.0f) & (v <= 0.0f) & (w <= 0.0f))) & (det != 0.0f);
    if (mask_bits(crossing.hit) == 0u) return crossing;
    const mask on_edge = crossing.hit & (minimum(fabs(u), minimum(fabs(v), fabs(w))) == 0.0f);
    if (mask_bits(on_edge) != 0u) {
        const real su = TRIANGLE(side)(u, bx, by, cx, cy), sv = TRIANGLE(side)(v, cx, cy, ax, ay), sw = TRIANGLE(side)(w, ax, ay, bx, by);
        crossing.hit &= ((su > 0.0f) & (sv > 0.0f) & (sw > 0.0f)) | ((su < 0.0f) & (sv < 0.0f) & (sw < 0.0f));
        if (mask_bits(crossing.hit) == 0u) return crossing;
    }

    crossing.u = v / det, crossing.v = w / det;
    const real z = u / det * az + crossing.u * bz + crossing.v * cz;
    crossing.t = z * ray.shear.z;
    // |z| is at most this if rounding of the vertices as the ray sees them can make up its sign: n bounds how much the plane is inclined.
    const real farthest = largest(maximum(absolute(make3(ax, ay, az)), maximum(absolute(make3(bx, by, bz)), absolute(make3(cx, cy, cz)))));
    const real ex = bx - ax, ey = by - ay, ez = bz - az, fx = cx - ax, fy = cy - ay, fz = cz - az;
    const real n = fabs(ey * fz - ez * fy) + fabs(ez * fx - ex * fz) + fabs(ex * fy - ey * fx);
    const real doubtful = 0x1p-19f * farthest * (n / fabs(det));
    const mask near = crossing.hit & (fabs(z) <= doubtful);
    crossing.hit &= near | ((crossing.t > 0.0f) & (crossing.t <= ray.t_max));
    if (mask_bits(crossing.hit) == 0u) return crossing;
    if (mask_bits(near) != 0u) {
        real3 a, b, c, normal;
        TRIANGLE(vertices)(block, j, &a, &b, &c);
        const real offset = TRIANGLE(plane_offset)(a, b, c, ray.origin, &normal);
        // Where the ray all but lies in the plane, the quotient's size means nothing; but it ends where it has passed all vertices.
        const real last = maximum(az * ray.shear.z, maximum(bz * ray.shear.z, cz * ray.shear.z));
        const real end = minimum(2.0f * doubtful * fabs(ray.shear.z), last);
        crossing.t = where(near, minimum(end, -offset / dot3(normal, ray.direction)), crossing.t);
        crossing.hit &= (crossing.t > 0.0f) & (crossing.t <= ray.t_max);
        if (mask_bits(crossing.hit) == 0u) return crossing;
    }
    LaneBox box;
    TRIANGLE(box)(block, j, &box);
    return within_box(crossing, box, ray);
}
