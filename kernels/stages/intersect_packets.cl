// Closest hits of a list of rays in packets of 16 neighbours: for rays that stay together. Same bits as intersect.
#include "kernels/accelerators/levels.cl"

/// hits[i] is the closest hit of ray live[first + i]; a hit beyond t_max or none has primitive NO_HIT. One tally per work-item.
kernel void intersect_packets(SCENE_PARAMS, LIVE_PARAMS, const global Ray *restrict rays, global Hit *restrict hits, global Tally *restrict tallies) {
    const Scene scene = SCENE;
    Tally tally = {{0u}, {0u}};
    const uint end = min((uint)(get_global_id(0) + 1u) * ITEMS_PER_WORK_ITEM, count);
    for (uint begin = get_global_id(0) * ITEMS_PER_WORK_ITEM; begin < end; begin += PACKET) {
        const Packet packet = packet_of(rays, live + first, begin, end);
        PacketHits closest;
        closest.u = (float16)(0.0f), closest.v = (float16)(0.0f), closest.primitive = (uint16)(NO_HIT);
        float16 t = vload16(0, packet.t_max);
        for (uint axis = 0u; axis < 3u; ++axis) {
            int16 lanes;
            ray_x16 ray = packet_rays(&packet, axis, scene.header->extent, &lanes);
            if (mask_bits(ray.t_max >= 0.0f) == 0u) continue;
            scene_closest_hits(scene, &ray, &closest);
            t = lanes ? ray.t_max : t;
        }
        float t_lane[PACKET], u[PACKET], v[PACKET];
        uint primitive[PACKET];
        vstore16(t, 0, t_lane), vstore16(closest.u, 0, u), vstore16(closest.v, 0, v), vstore16(closest.primitive, 0, primitive);
        for (uint i = begin; i < min(begin + PACKET, end); ++i) {
            const Hit hit = {t_lane[i - begin], u[i - begin], v[i - begin], primitive[i - begin]};
            const uint kind = rays[live[first + i]].kind;
            hits[i] = hit;
            tally.rays[kind] += 1u;
            tally.hits[kind] += hit.primitive != NO_HIT;
        }
    }
    tallies[get_global_id(0)] = tally;
}
