// Template: crossing of a ray with a triangle, for the lane width in force, as functions TRIANGLE(box) and TRIANGLE(crossing).

FUNCTION void TRIANGLE(box)(const global TriangleBlock *block, uint j, LaneBox *box) {
    const real3 a = make3(LANE(block->a[0], j), LANE(block->a[1], j), LANE(block->a[2], j));
    const real3 b = make3(LANE(block->b[0], j), LANE(block->b[1], j), LANE(block->b[2], j));
    const real3 c = make3(LANE(block->c[0], j), LANE(block->c[1], j), LANE(block->c[2], j));
    box->low = minimum(a, minimum(b, c)), box->high = maximum(a, maximum(b, c));
}

/// Watertight (Woop, Benthin, Wald, JCGT 2(1) 2013): a ray through an edge or a vertex hits one of the triangles that share it; the signs of
/// the edge functions are exact for the sheared vertices. Both sides count. u, v are the weights of vertices b and c.
/// A ray that begins in the triangle's plane, within rounding, does not meet it there; what lies further off is met, however thin or far it is.
FUNCTION Crossing TRIANGLE(crossing)(const global TriangleBlock *block, uint j, LaneRay ray) {
    const real ox = axis_of(ray.origin, ray.kx), oy = axis_of(ray.origin, ray.ky), oz = axis_of(ray.origin, ray.kz);
    const real az = LANE(block->a[ray.kz], j) - oz, bz = LANE(block->b[ray.kz], j) - oz, cz = LANE(block->c[ray.kz], j) - oz;
    const real ax = (LANE(block->a[ray.kx], j) - ox) - ray.shear.x * az, ay = (LANE(block->a[ray.ky], j) - oy) - ray.shear.y * az;
    const real bx = (LANE(block->b[ray.kx], j) - ox) - ray.shear.x * bz, by = (LANE(block->b[ray.ky], j) - oy) - ray.shear.y * bz;
    const real cx = (LANE(block->c[ray.kx], j) - ox) - ray.shear.x * cz, cy = (LANE(block->c[ray.ky], j) - oy) - ray.shear.y * cz;
    const real u = difference_of_products(cx, by, cy, bx);
    const real v = difference_of_products(ax, cy, ay, cx);
    const real w = difference_of_products(bx, ay, by, ax);
    const real det = u + v + w;

    Crossing crossing;
    crossing.t = 0.0f, crossing.u = 0.0f, crossing.v = 0.0f;
    crossing.hit = (((u >= 0.0f) & (v >= 0.0f) & (w >= 0.0f)) | ((u <= 0.0f) & (v <= 0.0f) & (w <= 0.0f))) & (det != 0.0f);
    if (mask_bits(crossing.hit) == 0u) return crossing;

    const real scaled_z = u * az + v * bz + w * cz;
    crossing.t = scaled_z * ray.shear.z / det, crossing.u = v / det, crossing.v = w / det;
    // |scaled_z| is the origin's distance from the plane times the length of n, which no rounding of the vertices changes by more than this.
    const real farthest = largest(maximum(absolute(make3(ax, ay, az)), maximum(absolute(make3(bx, by, bz)), absolute(make3(cx, cy, cz)))));
    const real ex = bx - ax, ey = by - ay, ez = bz - az, fx = cx - ax, fy = cy - ay, fz = cz - az;
    const real n = fabs(ey * fz - ez * fy) + fabs(ez * fx - ex * fz) + fabs(ex * fy - ey * fx);
    crossing.hit &= (crossing.t > 0.0f) & (fabs(scaled_z) > 0x1p-19f * farthest * n) & (crossing.t <= ray.t_max);
    if (mask_bits(crossing.hit) == 0u) return crossing;

    LaneBox box;
    TRIANGLE(box)(block, j, &box);
    return within_box(crossing, box, ray);
}
