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

/// A vertex as the ray sees it: in coordinates in which the ray begins at 0 and goes along z (Woop et al. section 3.1), but that z is not divided.
FUNCTION real3 TRIANGLE(sheared)(const global float (*vertex)[BLOCK_SIZE], uint j, LaneRay ray) {
    const real z = LANE(vertex[ray.kz], j) - ray.turned_origin.z;
    return make3(fma(-ray.shear.x, z, LANE(vertex[ray.kx], j) - ray.turned_origin.x),
                 fma(-ray.shear.y, z, LANE(vertex[ray.ky], j) - ray.turned_origin.y), z);
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
    const real3 a = TRIANGLE(sheared)(block->a, j, ray), b = TRIANGLE(sheared)(block->b, j, ray), c = TRIANGLE(sheared)(block->c, j, ray);
    const real u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
    const real det = u + v + w;
    const mask sign = REAL_BITS(det) & (mask)((int)0x80000000);
    const real su = BITS_REAL(REAL_BITS(u) ^ sign), sv = BITS_REAL(REAL_BITS(v) ^ sign), sw = BITS_REAL(REAL_BITS(w) ^ sign);
    const real t = fma(su, a.z, fma(sv, b.z, sw * c.z)) * ray.shear.z;
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
    const real3 a = TRIANGLE(sheared)(block->a, j, ray), b = TRIANGLE(sheared)(block->b, j, ray), c = TRIANGLE(sheared)(block->c, j, ray);
    Crossing crossing;
    crossing.t = 0.0f, crossing.u = 0.0f, crossing.v = 0.0f;
    crossing.hit = (LANE_NUMBER(block->primitive, j) != ray.source) & TRIANGLE(may_cross)(a.x, a.y, b.x, b.y, c.x, c.y);
    if (mask_bits(crossing.hit) == 0u) return crossing;

    const real u = difference_of_products(c.x, b.y, c.y, b.x);
    const real v = difference_of_products(a.x, c.y, a.y, c.x);
    const real w = difference_of_products(b.x, a.y, b.y, a.x);
    const real det = u + v + w;

    crossing.hit &= (((u >= 0.0f) & (v >= 0.0f) & (w >= 0.0f)) | ((u <= 0.0f) & (v <= 0.0f) & (w <= 0.0f))) & (det != 0.0f);
    if (mask_bits(crossing.hit) == 0u) return crossing;
    const mask on_edge = crossing.hit & (minimum(fabs(u), minimum(fabs(v), fabs(w))) == 0.0f);
    if (mask_bits(on_edge) != 0u) {
        const real su = TRIANGLE(side)(u, b.x, b.y, c.x, c.y), sv = TRIANGLE(side)(v, c.x, c.y, a.x, a.y), sw = TRIANGLE(side)(w, a.x, a.y, b.x, b.y);
        crossing.hit &= ((su > 0.0f) & (sv > 0.0f) & (sw > 0.0f)) | ((su < 0.0f) & (sv < 0.0f) & (sw < 0.0f));
        if (mask_bits(crossing.hit) == 0u) return crossing;
    }

    crossing.u = v / det, crossing.v = w / det;
    const real z = u / det * a.z + crossing.u * b.z + crossing.v * c.z;
    crossing.t = z * ray.shear.z;
    // |z| is at most this if rounding of the vertices as the ray sees them can make up its sign: n bounds how much the plane is inclined.
    const real farthest = largest(maximum(absolute(a), maximum(absolute(b), absolute(c))));
    const real ex = b.x - a.x, ey = b.y - a.y, ez = b.z - a.z, fx = c.x - a.x, fy = c.y - a.y, fz = c.z - a.z;
    const real n = fabs(ey * fz - ez * fy) + fabs(ez * fx - ex * fz) + fabs(ex * fy - ey * fx);
    const real doubtful = 0x1p-19f * farthest * (n / fabs(det));
    const mask near = crossing.hit & (fabs(z) <= doubtful);
    crossing.hit &= near | ((crossing.t > 0.0f) & (crossing.t <= ray.t_max));
    if (mask_bits(crossing.hit) == 0u) return crossing;
    if (mask_bits(near) != 0u) {
        real3 p, q, r, normal;
        TRIANGLE(vertices)(block, j, &p, &q, &r);
        const real offset = TRIANGLE(plane_offset)(p, q, r, ray.origin, &normal);
        // Where the ray all but lies in the plane, the quotient's size means nothing; but it ends where it has passed all vertices.
        const real last = maximum(a.z * ray.shear.z, maximum(b.z * ray.shear.z, c.z * ray.shear.z));
        const real end = minimum(2.0f * doubtful * fabs(ray.shear.z), last);
        crossing.t = where(near, minimum(end, -offset / dot3(normal, ray.direction)), crossing.t);
        crossing.hit &= (crossing.t > 0.0f) & (crossing.t <= ray.t_max);
        if (mask_bits(crossing.hit) == 0u) return crossing;
    }
    LaneBox box;
    TRIANGLE(box)(block, j, &box);
    return within_box(crossing, box, ray);
}
