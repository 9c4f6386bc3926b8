// Blocks of instances against one ray or a packet: whoever enters an instance's box meets its group, in the group's space. To be included where the
// functions group_... are.
#include "kernels/accelerators/leaf.cl"
#include "kernels/primitives/instance.cl"

#include "kernels/core/lanes_8.cl"
#include "kernels/primitives/instance_hit.cl"

#include "kernels/core/lanes_16.cl"
#include "kernels/primitives/instance_hit.cl"
#include "kernels/primitives/transform.cl"

#include "kernels/core/lanes_1.cl"

#define INSTANCE_BLOCK(scene, group, block) (RECORDS(scene, InstanceBlock, (group)->blocks[INSTANCE_KIND]) + (block))

FUNCTION const global Group *group_of(Scene scene, uint instance) {
    return SCENE_ARRAY(scene, Group, groups) + SCENE_ARRAY(scene, Instance, instances)[instance].group;
}

/// The ray in the space of an instance's group. It leaves a primitive of that instance only if it is the one that it leaves in the world.
FUNCTION ray_x8 prepare_in_group(Scene scene, uint instance, const ray_x8 *world) {
    Ray ray;
    ray.origin = make3(world->origin.x.s0, world->origin.y.s0, world->origin.z.s0);
    ray.direction = make3(world->direction.x.s0, world->direction.y.s0, world->direction.z.s0);
    ray.t_max = world->t_max.s0;
    ray.tag = RAY_TAG(0u, world->source_instance.s0 == (int)instance ? (uint)world->source.s0 : NO_HIT);
    return prepare(ray_in_group(scene, instance, ray), group_of(scene, instance)->extent);
}

/// The nearest first.
FUNCTION uint least_of(uint bits, const float *values) {
    uint least = lowest_bit(bits);
    for (bits &= bits - 1u; bits != 0u; bits &= bits - 1u) least = values[lowest_bit(bits)] < values[least] ? lowest_bit(bits) : least;
    return least;
}

FUNCTION void instances_closest_hit(Scene scene, const global InstanceBlock *block, ray_x8 *ray, Nearest *nearest) {
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

/// The rays in the space of an instance's group; lanes that do not enter its box have t_max -1.
FUNCTION Packet packet_in_group(Scene scene, uint instance, const ray_x16 *world, int16 enters) {
    const global Transform *m = &SCENE_ARRAY(scene, Instance, instances)[instance].to_group;
    Packet packet;
    packet.origin = transformed_point(m, world->origin);
    packet.direction = transformed_direction(m, world->direction);
    packet.t_max = enters ? world->t_max : (float16)(-1.0f);
    packet.source = world->source_instance == (int16)((int)instance) ? world->source : (int16)((int)NO_HIT);
    packet.axis = major_axes(packet.direction);
    packet.tag = (int16)(0), packet.source_instance = (int16)(0);
    return packet;
}

FUNCTION void instances_closest_hits(Scene scene, const global InstanceBlock *block, PacketRays *packet, PacketHits *hits) {
    box_x8 box;
    instance_box(block, 0u, &box);
    for (uint bits = candidates(packet, block->primitive, box); bits != 0u; bits &= bits - 1u) {
        const uint j = lowest_bit(bits), instance = block->primitive[j];
        const crossing_x16 entry = instance_entry(block, j, packet->rays);
        if (mask_bits(entry.hit) == 0u) continue;
        const global Group *group = group_of(scene, instance);
        const Packet inner = packet_in_group(scene, instance, &packet->rays, entry.hit);
        hits->inside = instance, hits->entry = entry.t;
        for (uint axis = 0u; axis < 3u; ++axis) {
            const int16 lanes = packet_lanes(&inner, axis);
            if (mask_bits(lanes) == 0u) continue;
            PacketRays rays = packet_rays(&inner, axis, group->extent, lanes);
            group_closest_hits(scene, group, &rays, hits);
            packet->rays.t_max = lanes ? rays.rays.t_max : packet->rays.t_max;
        }
        packet->farthest = largest_lane(packet->rays.t_max);
    }
    hits->inside = 0u, hits->entry = (float16)(0.0f);
}

FUNCTION void instances_end_rays(Scene scene, const global InstanceBlock *block, PacketRays *packet) {
    box_x8 box;
    instance_box(block, 0u, &box);
    for (uint bits = candidates(packet, block->primitive, box); bits != 0u; bits &= bits - 1u) {
        const uint j = lowest_bit(bits), instance = block->primitive[j];
        const crossing_x16 entry = instance_entry(block, j, packet->rays);
        if (mask_bits(entry.hit) == 0u) continue;
        const global Group *group = group_of(scene, instance);
        const Packet inner = packet_in_group(scene, instance, &packet->rays, entry.hit);
        for (uint axis = 0u; axis < 3u; ++axis) {
            const int16 lanes = packet_lanes(&inner, axis);
            if (mask_bits(lanes) == 0u) continue;
            PacketRays rays = packet_rays(&inner, axis, group->extent, lanes);
            group_end_occluded(scene, group, &rays);
            packet->rays.t_max = lanes ? rays.rays.t_max : packet->rays.t_max;
        }
    }
}

// Leaves of the world: blocks of primitives or of instances.

FUNCTION void world_block_closest_hit(Scene scene, const global Group *group, uint kind, uint block, ray_x8 *ray, Nearest *nearest) {
    if (kind == INSTANCE_KIND)
        instances_closest_hit(scene, INSTANCE_BLOCK(scene, group, block), ray, nearest);
    else
        block_closest_hit(scene, group, kind, block, ray, nearest);
}

FUNCTION bool world_block_any_hit(Scene scene, const global Group *group, uint kind, uint block, const ray_x8 *ray, HitList *list) {
    if (kind == INSTANCE_KIND) return instances_any_hit(scene, INSTANCE_BLOCK(scene, group, block), ray, list);
    return block_any_hit(scene, group, kind, block, ray, list);
}

FUNCTION void world_block_closest_hits(Scene scene, const global Group *group, uint kind, uint block, PacketRays *packet, PacketHits *hits) {
    if (kind == INSTANCE_KIND)
        instances_closest_hits(scene, INSTANCE_BLOCK(scene, group, block), packet, hits);
    else
        block_closest_hits(scene, group, kind, block, packet, hits);
}

FUNCTION void world_block_ends_rays(Scene scene, const global Group *group, uint kind, uint block, PacketRays *packet) {
    if (kind == INSTANCE_KIND)
        instances_end_rays(scene, INSTANCE_BLOCK(scene, group, block), packet);
    else
        block_ends_rays(scene, group, kind, block, packet);
}
#undef INSTANCE_BLOCK
