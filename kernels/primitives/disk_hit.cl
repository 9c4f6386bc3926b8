// Template: crossing of a ray with a disk, for the lane width in force.

FUNCTION void disk_box(const global DiskBlock *block, uint j, LaneBox *box) {
    box->low = make3(LANE(block->low[0], j), LANE(block->low[1], j), LANE(block->low[2], j));
    box->high = make3(LANE(block->high[0], j), LANE(block->high[1], j), LANE(block->high[2], j));
}

/// Crossing in (0, t_max]. Twice the digits say on which side of the plane the ray begins, and how fast it comes nearer to it: t has all its digits
/// however near to the plane the ray begins and however flat it meets it. Its box is tested first: most rays miss it.
FUNCTION Crossing disk_crossing(const global DiskBlock *block, uint j, LaneRay ray) {
    Crossing crossing;
    crossing.t = 0.0f, crossing.u = 0.0f, crossing.v = 0.0f;
    crossing.hit = LANE_NUMBER(block->primitive, j) != ray.source;
    LaneBox box;
    disk_box(block, j, &box);
    crossing = within_box(crossing, box, ray);
    if (mask_bits(crossing.hit) == 0u) return crossing;
    const real entry = crossing.t;

    const real3 center = make3(LANE(block->center[0], j), LANE(block->center[1], j), LANE(block->center[2], j));
    const real3 normal = make3(LANE(block->normal[0], j), LANE(block->normal[1], j), LANE(block->normal[2], j));
    const real radius = LANE(block->radius, j);
    const real height = rounded(dot3(two_difference(ray.origin, center), normal)), rate = rounded(two_dot3(ray.direction, normal));
    const real t = -height / rate;
    const real3 x = plus(minus(ray.origin, center), scaled(ray.direction, t));
    crossing.t = maximum(t, entry);
    crossing.hit &= (dot3(x, x) <= radius * radius) & (t > 0.0f) & (crossing.t <= ray.t_max);
    return crossing;
}

/// As triangle_may_meet: where it is known only by finding the crossing, it may be.
FUNCTION mask disk_may_meet(const global DiskBlock *block, uint j, LaneRay ray, real doubt) { return ray.t_max >= 0.0f; }
