// Template: crossing of a ray with a triangle, for the lane width in force, as function TRIANGLE_CROSSING.

/// Watertight (Woop, Benthin, Wald, JCGT 2(1) 2013): a ray through an edge or a vertex hits one of the triangles that share it; the signs of
/// the edge functions are exact for the sheared vertices. Both sides count. u, v are the weights of vertices b and c.
/// A ray that begins in the triangle's plane, within rounding, does not meet it there (bounds after Pharr et al., PBR 4ed, 6.8.7).
FUNCTION Crossing TRIANGLE_CROSSING(const global TriangleBlock *block, uint j, LaneRay ray) {
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

    const real scaled_t = ray.shear.z * (u * az + v * bz + w * cz);
    crossing.t = scaled_t / det, crossing.u = v / det, crossing.v = w / det;
    const real max_x = largest(absolute(make3(ax, bx, cx))), max_y = largest(absolute(make3(ay, by, cy)));
    const real max_z = largest(absolute(make3(az, bz, cz))), max_e = largest(absolute(make3(u, v, w)));
    const real error_x = 0x1.8p-22f * (max_x + max_z), error_y = 0x1.8p-22f * (max_y + max_z);  // at least gamma(5)
    const real error_e = 2.0f * (0x1p-22f * max_x * max_y + error_y * max_x + error_x * max_y);
    const real error_t = 3.0f * (0x1p-21f * max_e * max_z + error_e * max_z) * fabs(ray.shear.z);
    crossing.hit &= (crossing.t > 0.0f) & (fabs(scaled_t) > error_t) & (crossing.t <= ray.t_max);
    if (mask_bits(crossing.hit) == 0u) return crossing;

    const real3 a = make3(LANE(block->a[0], j), LANE(block->a[1], j), LANE(block->a[2], j));
    const real3 b = make3(LANE(block->b[0], j), LANE(block->b[1], j), LANE(block->b[2], j));
    const real3 c = make3(LANE(block->c[0], j), LANE(block->c[1], j), LANE(block->c[2], j));
    return within_box(crossing, minimum(a, minimum(b, c)), maximum(a, maximum(b, c)), ray);
}
