// Visibility along shadow rays, in packets of neighbours: the rays of a row go to one light.
#include "kernels/accelerators/packet_levels.cl"
#include "kernels/core/tally.cl"

/// Work-items (chunk, row). Row r's rays are live[r * stride ...], counts[r] of them, each an index into `rays` and `visible`; visible[k]
/// becomes 0 where something is met before the ray's t_max, and stays as it is elsewhere. Rays and hits are added to a tally per work-item. In scenes
/// with instances instances[i] is that of the primitive which the rays r * stride + i leave.
kernel void trace_shadow_rays(SCENE_PARAMS, const global uint *restrict live, const global uint *restrict counts, uint stride,
                              const global Ray *restrict rays, const global uint *restrict instances, global uchar *restrict visible,
                              global Tally *restrict tallies) {
    const Scene scene = SCENE;
    const uint row = get_global_id(1);
    const global uint *list = live + row * stride;
    Tally tally = {{0ul}, {0ul}};
    const uint end = min((uint)(get_global_id(0) + 1u) * ITEMS_PER_WORK_ITEM, counts[row]);
    for (uint begin = get_global_id(0) * ITEMS_PER_WORK_ITEM; begin < end; begin += PACKET) {
        const Packet packet = packet_of(rays, list, begin, end, instances, row * stride);
        tally.rays[RAY_SHADOW] += min(PACKET, end - begin);
        uint occluded[ROWS];
        scene_occluded(scene, &packet, occluded);
        FOR_EACH_ROW(r) {
            for (uint bits = occluded[r]; bits != 0u; bits &= bits - 1u) {
                visible[list[begin + r * ROW + lowest_bit(bits)]] = 0;
                tally.hits[RAY_SHADOW] += 1u;
            }
        }
    }
    add_tally(tallies + get_global_id(0) + get_global_size(0) * row, tally);
}
