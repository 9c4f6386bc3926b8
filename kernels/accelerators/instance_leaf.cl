// Blocks of instances against one ray: whoever enters an instance's box meets its group, in the group's space. To be included where the functions
// group_... are.
#include "kernels/accelerators/instance_groups.cl"
#include "kernels/accelerators/leaf.cl"

/// The ray in the space of an instance's group. It leaves a primitive of that instance only if it is the one that it leaves in the world.
FUNCTION Ray ray_in_instance(Scene scene, uint instance, const ray_x8 *world) {
    Ray ray;
    ray.origin = make3(world->origin.x.s0, world->origin.y.s0, world->origin.z.s0);
    ray.direction = make3(world->direction.x.s0, world->direction.y.s0, world->direction.z.s0);
    ray.t_max = world->t_max.s0;
    ray.tag = RAY_TAG(0u, world->source_instance.s0 == (int)instance ? (uint)world->source.s0 : NO_HIT);
    return ray_in_group(scene, instance, ray);
}

FUNCTION ray_x8 prepare_in_group(Scene scene, uint instance, const ray_x8 *world) {
    ray_x8 inner = prepare(ray_in_instance(scene, instance, world), group_of(scene, instance)->extent);
    SHARE_WORK(inner, world);
    return inner;
}

/// The nearest first.
FUNCTION uint least_of(uint bits, const float *values) {
    uint least = lowest_bit(bits);
    for (bits &= bits - 1u; bits != 0u; bits &= bits - 1u) least = values[lowest_bit(bits)] < values[least] ? lowest_bit(bits) : least;
    return least;
}

FUNCTION void instances_closest_hit(Scene scene, const global InstanceBlock *block, ray_x8 *ray, Nearest *nearest) {
    COUNT(ray, blocks, 1u);
    const crossing_x8 entries = instance_entry(block, 0u, *ray);
    uint bits = mask_bits(entries.hit);
    if (bits == 0u) return;
    float entry[8];
    vstore8(entries.t, 0, entry);
    while (bits != 0u) {
        const uint j = least_of(bits, entry), instance = block->primitive[j];
        if (entry[j] > ray->t_max.s0) break;
        bits &= ~(1u << j);
        nearest->inside = instance, nearest->entry = entry[j];
        ray_x8 inner = prepare_in_group(scene, instance, ray);
        group_closest_hit(scene, group_of(scene, instance), &inner, nearest);
        ray->t_max = inner.t_max;
    }
    nearest->inside = 0u, nearest->entry = 0.0f;
}

FUNCTION bool instances_any_hit(Scene scene, const global InstanceBlock *block, const ray_x8 *ray, HitList *list) {
    COUNT(ray, blocks, 1u);
    const crossing_x8 entries = instance_entry(block, 0u, *ray);
    uint bits = mask_bits(entries.hit);
    if (bits == 0u) return false;
    float entry[8];
    vstore8(entries.t, 0, entry);
    for (; bits != 0u; bits &= bits - 1u) {
        const uint j = lowest_bit(bits), instance = block->primitive[j];
        if (list != 0) list->inside = instance, list->entry = entry[j];
        const ray_x8 inner = prepare_in_group(scene, instance, ray);
        if (group_any_hit(scene, group_of(scene, instance), &inner, list)) return true;
    }
    if (list != 0) list->inside = 0u, list->entry = 0.0f;
    return false;
}

// Leaves of the world: blocks of primitives or of instances.

FUNCTION void world_block_closest_hit(Scene scene, const global Group *group, uint kind, uint block, ray_x8 *ray, Nearest *nearest) {
    if (kind == INSTANCE_KIND)
        instances_closest_hit(scene, instance_block(scene, group, block), ray, nearest);
    else
        block_closest_hit(scene, group, kind, block, ray, nearest);
}

FUNCTION bool world_block_any_hit(Scene scene, const global Group *group, uint kind, uint block, const ray_x8 *ray, HitList *list) {
    if (kind == INSTANCE_KIND) return instances_any_hit(scene, instance_block(scene, group, block), ray, list);
    return block_any_hit(scene, group, kind, block, ray, list);
}
