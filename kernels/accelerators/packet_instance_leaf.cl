// Blocks of instances against a packet: as instance_leaf.cl has it, for 16 rays at once. To be included where the functions group_... are.
#include "kernels/accelerators/instance_groups.cl"
#include "kernels/accelerators/packet_leaf.cl"

#include "kernels/core/lanes_16.cl"
#include "kernels/primitives/instance_hit.cl"
#include "kernels/primitives/transform.cl"

#include "kernels/core/lanes_1.cl"

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

FUNCTION void world_block_closest_hits(Scene scene, const global Group *group, uint kind, uint block, PacketRays *packet, PacketHits *hits) {
    if (kind == INSTANCE_KIND)
        instances_closest_hits(scene, instance_block(scene, group, block), packet, hits);
    else
        block_closest_hits(scene, group, kind, block, packet, hits);
}

FUNCTION void world_block_ends_rays(Scene scene, const global Group *group, uint kind, uint block, PacketRays *packet) {
    if (kind == INSTANCE_KIND)
        instances_end_rays(scene, instance_block(scene, group, block), packet);
    else
        block_ends_rays(scene, group, kind, block, packet);
}
