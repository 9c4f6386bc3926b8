// Blocks of instances against one ray: whoever enters an instance's box meets its group, in the group's space. To be included where the functions
// group_... are.
#include "kernels/accelerators/instance_groups.cl"
#include "kernels/accelerators/leaf.cl"

#include "kernels/core/lanes_1.cl"
#include "kernels/primitives/instance_hit.cl"

/// The ray in the space of an instance's group. It leaves a primitive of that instance only if it is the one that it leaves in the world.
FUNCTION Ray ray_in_instance(Scene scene, uint instance, const SingleRay *world) {
    Ray ray;
    ray.origin = first_lane(world->origin), ray.direction = first_lane(world->direction), ray.t_max = first_lane(world->t_max);
    ray.tag = RAY_TAG(0u, first_lane(world->source_instance) == (int)instance ? (uint)first_lane(world->source) : NO_HIT);
    return ray_in_group(scene, PLACEMENT(instance, first_lane(world->time)), ray);
}

FUNCTION SingleRay prepare_in_group(Scene scene, uint instance, const SingleRay *world) {
    SingleRay inner = prepare_single(ray_in_instance(scene, instance, world), group_of(scene, instance)->extent);
    SHARE_WORK(inner, world);
    return inner;
}

/// Bits of the block's instances whose boxes the ray enters, and where.
FUNCTION uint entered_instances(const global InstanceBlock *block, const SingleRay *ray, float *entry) {
    uint bits = 0u;
    FOR_EACH_PART(first, block->primitive) {
        const SingleCrossing crossing = instance_entry(block, first, *ray);
        bits |= mask_bits(crossing.hit) << first;
        store_lanes(crossing.t, entry + first);
    }
    return bits;
}

/// The nearest first.
FUNCTION uint least_of(uint bits, const float *values) {
    uint least = lowest_bit(bits);
    for (bits &= bits - 1u; bits != 0u; bits &= bits - 1u) least = values[lowest_bit(bits)] < values[least] ? lowest_bit(bits) : least;
    return least;
}

FUNCTION void instances_closest_hit(Scene scene, const global InstanceBlock *block, SingleRay *ray, Nearest *nearest) {
    COUNT(ray, blocks, 1u);
    float entry[BLOCK_SIZE];
    uint bits = entered_instances(block, ray, entry);
    while (bits != 0u) {
        const uint j = least_of(bits, entry), instance = block->primitive[j];
        if (entry[j] > first_lane(ray->t_max)) break;
        bits &= ~(1u << j);
        nearest->inside = instance, nearest->entry = entry[j];
        SingleRay inner = prepare_in_group(scene, instance, ray);
        group_closest_hit(scene, group_of(scene, instance), &inner, nearest);
        ray->t_max = inner.t_max;
    }
    nearest->inside = 0u, nearest->entry = 0.0f;
}

FUNCTION bool instances_any_hit(Scene scene, const global InstanceBlock *block, const SingleRay *ray, HitList *list) {
    COUNT(ray, blocks, 1u);
    float entry[BLOCK_SIZE];
    for (uint bits = entered_instances(block, ray, entry); bits != 0u; bits &= bits - 1u) {
        const uint j = lowest_bit(bits), instance = block->primitive[j];
        if (list != 0) list->inside = instance, list->entry = entry[j];
        const SingleRay inner = prepare_in_group(scene, instance, ray);
        if (group_any_hit(scene, group_of(scene, instance), &inner, list)) return true;
    }
    if (list != 0) list->inside = 0u, list->entry = 0.0f;
    return false;
}

// Leaves of the world: blocks of primitives or of instances.

FUNCTION void world_block_closest_hit(Scene scene, const global Group *group, uint kind, uint block, SingleRay *ray, Nearest *nearest) {
    if (kind == INSTANCE_KIND)
        instances_closest_hit(scene, instance_block(scene, group, block), ray, nearest);
    else
        block_closest_hit(scene, group, kind, block, ray, nearest);
}

FUNCTION bool world_block_any_hit(Scene scene, const global Group *group, uint kind, uint block, const SingleRay *ray, HitList *list) {
    if (kind == INSTANCE_KIND) return instances_any_hit(scene, instance_block(scene, group, block), ray, list);
    return block_any_hit(scene, group, kind, block, ray, list);
}
