// Rays in packets of neighbours and one after another: what they meet, and whether they meet anything.
#define ROWS 4u
#include "kernels/accelerators/levels.cl"
#include "kernels/accelerators/packet_levels.cl"

FUNCTION bool is_same(PacketHits packet, uint j, Hit hit) {
    float t[PACKET], u[PACKET], v[PACKET];
    uint primitive[PACKET];
    FOR_EACH_ROW(r) {
        const RowHits row = packet.rows[r];
        vstore16(row.t, r, t), vstore16(row.u, r, u), vstore16(row.v, r, v), vstore16(row.primitive, r, primitive);
    }
    const bool numbers = as_uint(t[j]) == as_uint(hit.t) && as_uint(u[j]) == as_uint(hit.u) && as_uint(v[j]) == as_uint(hit.v);
    return primitive[j] == hit.primitive && (numbers || hit.primitive == NO_HIT);
}

/// hits[i] is what ray i meets on its own. Bit 0 of differences[i]: in a packet it meets something else; bit 1: a packet says otherwise whether it is
/// occluded; bit 2: so does the ray itself. live[i] is i.
kernel void test_packets(SCENE_PARAMS, const global Ray *restrict rays, const global uint *restrict live, uint count, global Hit *restrict hits,
                         global uchar *restrict differences) {
    const Scene scene = SCENE;
    const uint end = min((uint)(get_global_id(0) + 1u) * ITEMS_PER_WORK_ITEM, count);
    for (uint begin = get_global_id(0) * ITEMS_PER_WORK_ITEM; begin < end; begin += PACKET) {
        const Packet packet = packet_of(rays, live, begin, end, live, 0u);
        const PacketHits closest = scene_closest_hits(scene, &packet);
        uint occluded[ROWS];
        scene_occluded(scene, &packet, occluded);
        for (uint j = 0u; j < min(PACKET, end - begin); ++j) {
            const Hit hit = scene_closest_hit(scene, rays[begin + j], PLACEMENT(0u, 0.0f)).hit;
            const uint is_hit = hit.primitive != NO_HIT, alone = scene_any_hit(scene, rays[begin + j], PLACEMENT(0u, 0.0f), 0);
            hits[begin + j] = hit;
            differences[begin + j] =
                (is_same(closest, j, hit) ? 0u : 1u) | ((occluded[j / ROW] >> j % ROW & 1u) != is_hit ? 2u : 0u) | (alone != is_hit ? 4u : 0u);
        }
    }
}
