// Blocks of instances against a packet: as instance_leaf.cl has it, for all its rays. To be included where the functions group_... are.
#include "kernels/accelerators/instance_groups.cl"
#include "kernels/accelerators/packet_leaf.cl"

#include "kernels/core/lanes_16.cl"
#include "kernels/primitives/instance_hit.cl"
#include "kernels/primitives/transform.cl"

#include "kernels/core/lanes_1.cl"
#include "generated/instance_rows.cl"

/// The rays in the space of an instance's group; lanes that do not enter its box have t_max -1.
FUNCTION Row row_in_group(Scene scene, uint instance, const ray_x16 *world, int16 enters) {
    Row row;
    transform_row(scene, instance, world, enters, &row);
    row.t_max = enters ? world->t_max : (float16)(-1.0f);
    row.source = world->source_instance == (int16)((int)instance) ? world->source : (int16)((int)NO_HIT);
    row.axis = major_axes(row.direction);
    row.tag = (int16)(0), row.source_instance = (int16)(0);
    SET_TIME(row, (float16)(0.0f));
    return row;
}

/// Those of the rows whose bits are set and which enter instance j of the block, in its group; false if none does. entries: where.
FUNCTION bool enter_instance(Scene scene, const global InstanceBlock *block, uint j, uint rows, const PacketRays *packet, Packet *inner,
                             float16 *entries) {
    int16 any = (int16)(0);
    FOR_EACH_ROW(r) {
        const crossing_x16 entry = instance_entry(block, j, packet->rows[r]);
        const int16 enters = (rows >> r & 1u) != 0u ? entry.hit : (int16)(0);
        inner->rows[r] = row_in_group(scene, block->primitive[j], &packet->rows[r], enters);
        entries[r] = entry.t;
        any |= enters;
    }
    return mask_bits(any) != 0u;
}

/// Rays whose direction in the group is largest along `axis` have been traced there: what is left of them.
FUNCTION void take_ends(const Packet *inner, uint axis, const PacketRays *traced, PacketRays *packet) {
    FOR_EACH_ROW(r) {
        ray_x16 *ray = &packet->rows[r];
        ray->t_max = lanes_along(&inner->rows[r], axis) ? traced->rows[r].t_max : ray->t_max;
    }
}

FUNCTION void instances_closest_hits(Scene scene, const global InstanceBlock *block, uint rows, PacketRays *packet, PacketHits *hits) {
    CANDIDATES_OF(instance, packet, block, bits);
    for (; bits != 0u; bits &= bits - 1u) {
        const uint j = lowest_bit(bits);
        Packet inner;
        float16 entries[ROWS];
        if (!enter_instance(scene, block, j, rows, packet, &inner, entries)) continue;
        const global Group *group = group_of(scene, block->primitive[j]);
        hits->inside = block->primitive[j];
        FOR_EACH_ROW(r) hits->rows[r].entry = entries[r];
        for (uint axis = 0u; axis < 3u; ++axis) {
            if (!any_along(&inner, axis)) continue;
            PacketRays rays = packet_rays(&inner, axis, group->extent);
            group_closest_hits(scene, group, &rays, hits);
            take_ends(&inner, axis, &rays, packet);
        }
        packet->farthest = farthest_of(packet);
    }
    hits->inside = 0u;
    FOR_EACH_ROW(r) hits->rows[r].entry = (float16)(0.0f);
}

FUNCTION void instances_end_rays(Scene scene, const global InstanceBlock *block, uint rows, PacketRays *packet) {
    CANDIDATES_OF(instance, packet, block, bits);
    for (; bits != 0u; bits &= bits - 1u) {
        const uint j = lowest_bit(bits);
        Packet inner;
        float16 entries[ROWS];
        if (!enter_instance(scene, block, j, rows, packet, &inner, entries)) continue;
        const global Group *group = group_of(scene, block->primitive[j]);
        for (uint axis = 0u; axis < 3u; ++axis) {
            if (!any_along(&inner, axis)) continue;
            PacketRays rays = packet_rays(&inner, axis, group->extent);
            group_end_occluded(scene, group, &rays);
            take_ends(&inner, axis, &rays, packet);
        }
    }
}

// Leaves of the world: blocks of primitives or of instances.

FUNCTION void world_block_closest_hits(Scene scene, const global Group *group, uint kind, uint block, uint rows, PacketRays *packet,
                                       PacketHits *hits) {
    if (kind == INSTANCE_KIND)
        instances_closest_hits(scene, instance_block(scene, group, block), rows, packet, hits);
    else
        block_closest_hits(scene, group, kind, block, rows, packet, hits);
}

FUNCTION void world_block_ends_rays(Scene scene, const global Group *group, uint kind, uint block, uint rows, PacketRays *packet) {
    if (kind == INSTANCE_KIND)
        instances_end_rays(scene, instance_block(scene, group, block), rows, packet);
    else
        block_ends_rays(scene, group, kind, block, rows, packet);
}
