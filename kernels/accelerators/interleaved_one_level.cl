// Rays in turn in scenes without instances: they stay in the world.

FUNCTION ulong address_of(const Course *course, const Traversal *traversal, uint word) {
    const Target target = course->targets[word >> BVH_TARGET_SHIFT];
    return target.address + (ulong)(word & BVH_BLOCK) * target.size;
}

FUNCTION void closest_block_step(const Course *course, Traversal *traversal) {}
FUNCTION void closest_instance_step(const Course *course, Traversal *traversal) {}
FUNCTION void any_block_step(const Course *course, Traversal *traversal) {}
FUNCTION void any_instance_step(const Course *course, Traversal *traversal) {}
FUNCTION void closest_leave(const Course *course, Traversal *traversal) {}
FUNCTION void any_leave(const Course *course, Traversal *traversal) {}
