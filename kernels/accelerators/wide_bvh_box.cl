// Template: whether a ray meets children of a node, for the level and the lane width in force: LANE(column, c) is child c, or all of them.

/// Before its t_max; and where it enters them, never negative.
FUNCTION mask LEVEL(meets_child)(const global BvhNode *node, uint c, const LaneRay *ray, real *enter) {
    const real3 inverse = ray->inverse, low = ray->shift_low, high = ray->shift_high;
    const bool x = first_lane(inverse.x) < 0.0f, y = first_lane(inverse.y) < 0.0f, z = first_lane(inverse.z) < 0.0f;
    const real near_x = fma(LANE((x ? node->high : node->low)[0], c), inverse.x, x ? high.x : low.x);
    const real near_y = fma(LANE((y ? node->high : node->low)[1], c), inverse.y, y ? high.y : low.y);
    const real near_z = fma(LANE((z ? node->high : node->low)[2], c), inverse.z, z ? high.z : low.z);
    const real far_x = fma(LANE((x ? node->low : node->high)[0], c), inverse.x, x ? low.x : high.x);
    const real far_y = fma(LANE((y ? node->low : node->high)[1], c), inverse.y, y ? low.y : high.y);
    const real far_z = fma(LANE((z ? node->low : node->high)[2], c), inverse.z, z ? low.z : high.z);
    *enter = maximum(maximum(near_x, near_y), maximum(near_z, (real)(0.0f)));
    return *enter <= minimum(minimum(far_x, far_y), minimum(far_z, ray->t_max));
}
