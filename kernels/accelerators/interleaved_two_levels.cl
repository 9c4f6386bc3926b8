// Rays in turn in scenes with instances. A ray comes to a block of instances, puts those whose boxes it meets on its stack, and enters them one by
// one: it takes its turns in the group as in the world, until BVH_LEAVE is all that is left on its stack of what it met there.

/// A block of instances is at hand when one of its own comes next.
FUNCTION ulong address_of(const Course *course, const Traversal *traversal, uint word) {
    const global Span *spans = word < BVH_LEAF ? &traversal->group->nodes : traversal->group->blocks + (word >> BVH_KIND_SHIFT & 7u);
    return (ulong)RECORDS(course->scene, uchar, *spans) + (ulong)(word & BVH_BLOCK) * course->targets[word >> BVH_TARGET_SHIFT].size;
}

FUNCTION uint8 instance_words(uint block) { return (uint8)(0, 1, 2, 3, 4, 5, 6, 7) + (uint8)(BVH_INSTANCE | block * BLOCK_SIZE); }

/// What a ray meets in a group, by the ray in its space, begins at the root.
FUNCTION void enter(const Course *course, Traversal *traversal, uint instance, const ray_x8 *world) {
    const global Group *group = group_of(course->scene, instance);
    const bool goes_on = prepare_lane(ray_in_instance(course->scene, instance, world), 0, group->extent, traversal->inside, traversal->place);
    traversal->rays = traversal->inside, traversal->lane = traversal->place;
    traversal->group = group;
    traversal->nodes = RECORDS(course->scene, BvhNode, group->nodes);
    // The end of the instance is entered at no t that the ray's could be less than.
    const uint size = traversal->size;
    traversal->children[size] = BVH_LEAVE, traversal->entered[BVH_WIDTH + size - 1u] = INT_MIN;
    traversal->children[size + 1u] = 0u, traversal->entered[BVH_WIDTH + size] = 0;
    traversal->size = size + goes_on;
}

/// To the world, from an instance that has nothing more for the ray.
FUNCTION void leave(const Course *course, Traversal *traversal) {
    traversal->rays = traversal->world_rays, traversal->lane = traversal->world_lane;
    traversal->group = course->world, traversal->nodes = course->nodes;
    traversal->nearest.inside = 0u, traversal->nearest.entry = 0.0f;
}

FUNCTION void closest_leave(const Course *course, Traversal *traversal) {
    leave(course, traversal);
    traversal->size = size_before(traversal, traversal->size - 1u, traversal->t_max);
}

FUNCTION void any_leave(const Course *course, Traversal *traversal) {
    leave(course, traversal);
    --traversal->size;
}

FUNCTION void closest_block_step(const Course *course, Traversal *traversal) {
    const uint block = traversal->children[traversal->size] & BVH_BLOCK, rest = size_before(traversal, traversal->size - 1u, traversal->t_max);
    const ray_x8 ray = widened(traversal->rays, traversal->lane, traversal->t_max);
    const crossing_x8 entries = instance_entry(instance_block(course->scene, course->world, block), 0u, ray);
    push_nearest_last(traversal, rest, entries.hit, maximum(entries.t, (float8)(0.0f)), instance_words(block));
}

FUNCTION void any_block_step(const Course *course, Traversal *traversal) {
    const uint block = traversal->children[traversal->size] & BVH_BLOCK;
    const ray_x8 ray = widened(traversal->rays, traversal->lane, traversal->t_max);
    const crossing_x8 entries = instance_entry(instance_block(course->scene, course->world, block), 0u, ray);
    push(traversal, mask_bits(entries.hit), instance_words(block));
}

FUNCTION void closest_instance_step(const Course *course, Traversal *traversal) {
    const uint number = traversal->children[traversal->size] & BVH_BLOCK, lane = number % BLOCK_SIZE;
    const ray_x8 ray = widened(traversal->rays, traversal->lane, traversal->t_max);
    const global InstanceBlock *block = instance_block(course->scene, course->world, number / BLOCK_SIZE);
    float entry[BLOCK_SIZE];
    vstore8(instance_entry(block, 0u, ray).t, 0, entry);
    traversal->nearest.inside = block->primitive[lane], traversal->nearest.entry = entry[lane];
    enter(course, traversal, block->primitive[lane], &ray);
}

FUNCTION void any_instance_step(const Course *course, Traversal *traversal) {
    const uint number = traversal->children[traversal->size] & BVH_BLOCK;
    const ray_x8 ray = widened(traversal->rays, traversal->lane, traversal->t_max);
    enter(course, traversal, instance_block(course->scene, course->world, number / BLOCK_SIZE)->primitive[number % BLOCK_SIZE], &ray);
}
