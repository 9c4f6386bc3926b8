// Template: where a ray enters the box of an instance in the world, for the lane width in force.

FUNCTION void instance_box(const global InstanceBlock *block, uint j, LaneBox *box) {
    box->low = make3(LANE(block->low[0], j), LANE(block->low[1], j), LANE(block->low[2], j));
    box->high = make3(LANE(block->high[0], j), LANE(block->high[1], j), LANE(block->high[2], j));
}

/// At t = 0 where it begins in the box.
FUNCTION Crossing instance_entry(const global InstanceBlock *block, uint j, LaneRay ray) {
    Crossing entry;
    entry.t = 0.0f, entry.u = 0.0f, entry.v = 0.0f;
    entry.hit = (entry.t == 0.0f);
    LaneBox box;
    instance_box(block, j, &box);
    return within_box(entry, box, ray);
}
