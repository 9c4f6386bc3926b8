// Closest hits of a list of rays in packets of neighbours: for rays that stay together. Same bits as intersect.
#define ROWS 4u
#include "generated/instances.cl"
#include "kernels/accelerators/packet_levels.cl"
#include "kernels/accelerators/row_results.cl"
#include "kernels/core/tally.cl"

FUNCTION void store_hits(global Hit *hits, uint count, RowHits closest) {
    float4 hit[ROW];
    hits_of_row(closest, hit);
    for (uint j = 0u; j < count; ++j) vstore4(hit[j], j, (global float *)hits);
}

FUNCTION void store_instances(global uint *instances, uint first, uint count, const Row *row, RowHits closest) {
    uint instance[ROW];
    vstore16(closest.primitive == (uint16)(NO_HIT) ? (uint16)(0u) : closest.instance, 0, instance);
    for (uint j = 0u; j < count; ++j) store_instance(instances, first + j, PLACEMENT(instance[j], LANE_TIME(*row, j)));
}

FUNCTION void store_crowded(global uchar *crowded, uint count, RowHits closest) {
    const uint bits = crowded_lanes(closest);
    for (uint j = 0u; j < count; ++j) crowded[j] = bits >> j & 1u;
}

/// hits[i] is the closest hit of ray live[first + i]; a hit beyond t_max or none has primitive NO_HIT. Rays and hits are added to a tally per
/// work-item. crowded, sources and instances are as intersect says.
kernel void intersect_packets(SCENE_PARAMS, LIVE_PARAMS, const global Ray *restrict rays, const global uint *restrict sources,
                              global Hit *restrict hits, global uint *restrict instances, global uchar *restrict crowded,
                              global Tally *restrict tallies) {
    const Scene scene = SCENE;
    Tally tally = {{0ul}, {0ul}};
    const uint end = min((uint)(get_global_id(0) + 1u) * ITEMS_PER_WORK_ITEM, count);
    for (uint begin = get_global_id(0) * ITEMS_PER_WORK_ITEM; begin < end; begin += PACKET) {
        const Packet packet = packet_of(rays, live + first, begin, end, sources, 0u);
        const PacketHits closest = scene_closest_hits(scene, &packet);
        FOR_EACH_ROW(r) {
            const uint start = begin + r * ROW, rays_here = rays_of_row(r, begin, end);
            store_hits(hits + start, rays_here, closest.rows[r]);
            if (INSTANCES) store_instances(instances, start, rays_here, &packet.rows[r], closest.rows[r]);
            if (INTERIOR_SIZE > 0u) store_crowded(crowded + start, rays_here, closest.rows[r]);
            count_rays(&packet.rows[r], first_lanes(rays_here), &closest.rows[r], &tally);
        }
    }
    add_tally(tallies + get_global_id(0), tally);
}
