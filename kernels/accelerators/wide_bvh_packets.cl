// Template, included once per level: LEVEL(name) names its functions, the LEAF_ macros test one block.
// Bounding volume hierarchy of 8 children per node: the packet's intervals against 8 boxes at once, its rays against one when its turn comes, when
// many have ended already.
#include "kernels/accelerators/wide_bvh.h"
#include "kernels/core/lane_order.cl"

#define BVH_STACK (BVH_PENDING + BVH_WIDTH)

/// Bits of the packet's rows with rays that meet child `c` before their t_max.
FUNCTION uint LEVEL(rows_entering)(const global BvhNode *node, uint c, const PacketRays *packet) {
    uint rows = 0u;
    FOR_EACH_ROW(r) {
        const ray_x16 *ray = &packet->rows[r];
#define AT(side, axis, component, shift) fma((float16)(node->side[axis][c]), ray->inverse.component, ray->shift.component)
        const vec3x16 a = make3(AT(low, 0, x, shift_low), AT(low, 1, y, shift_low), AT(low, 2, z, shift_low));
        const vec3x16 b = make3(AT(high, 0, x, shift_high), AT(high, 1, y, shift_high), AT(high, 2, z, shift_high));
#undef AT
        const vec3x16 nears = minimum(a, b), fars = maximum(a, b);
        const float16 near = maximum(maximum(nears.x, nears.y), maximum(nears.z, (float16)(0.0f)));
        const float16 far = minimum(minimum(fars.x, fars.y), minimum(fars.z, ray->t_max));
        rows |= mask_bits(near <= far) != 0u ? 1u << r : 0u;
    }
    return rows;
}

/// Children that the packet may meet, and where it enters them at the earliest.
FUNCTION int8 LEVEL(children_of_packet)(const global BvhNode *node, const PacketRays *packet, float8 *enter) {
#define PLANES(side) make3(*(const global float8 *)(side)[0], *(const global float8 *)(side)[1], *(const global float8 *)(side)[2])
    box_x8 box;
    box.low = PLANES(node->low), box.high = PLANES(node->high);
#undef PLANES
    return candidates(packet, node->child, box, enter);
}

/// Children wait with their places: 8 · node + lane. The nearest comes first.
static void LEVEL(closest_hits)(Scene scene, const global Group *group, PacketRays *packet, PacketHits *hits) {
    const global BvhNode *nodes = RECORDS(scene, BvhNode, group->nodes);
    uint children[BVH_STACK], places[BVH_STACK];
    int entered[BVH_STACK];  // bits of the t where the packet enters a child, but for the last three: not above it
    uint size = 0u, current = 0u, rows = ALL_ROWS;
    for (;;) {
        if ((current & BVH_LEAF) == 0u) {
            const global BvhNode *node = nodes + current;
            float8 enter;
            const int8 met = LEVEL(children_of_packet)(node, packet, &enter);
            const uint bits = mask_bits(met);
            if ((bits & (bits - 1u)) != 0u) {
                const int8 lane = (int8)(0, 1, 2, 3, 4, 5, 6, 7);
                const int8 order = sorted(met ? (as_int8(enter) & (int8)(~7)) | lane : (int8)(-1));
                vstore8(order, 0, entered + size);
                vstore8(picked(*(const global uint8 *)node->child, as_uint8(order)), 0, children + size);
                vstore8((as_uint8(order) & 7u) | (uint8)(current << 3), 0, places + size);
                size += popcount(bits);
            } else if (bits != 0u) {
                rows = LEVEL(rows_entering)(node, lowest_bit(bits), packet);
                if (rows != 0u) {
                    current = node->child[lowest_bit(bits)];
                    continue;
                }
            }
        } else {
            LEAF_CLOSEST_HITS(scene, group, current >> BVH_KIND_SHIFT & 7u, current & BVH_BLOCK, rows, packet, hits);
        }
        do {
            do {
                if (size == 0u) return;
                --size;
            } while ((entered[size] & ~7) > as_int(packet->farthest));
            rows = LEVEL(rows_entering)(nodes + (places[size] >> 3), places[size] & 7u, packet);
        } while (rows == 0u);
        current = children[size];
    }
}

/// Ends every ray that meets something: its t_max becomes -1. The children with the fewest primitives come first, as in any_hit.
static void LEVEL(end_occluded)(Scene scene, const global Group *group, PacketRays *packet) {
    const global BvhNode *nodes = RECORDS(scene, BvhNode, group->nodes);
    uint children[BVH_STACK], places[BVH_STACK];
    uint size = 0u, current = 0u, rows = ALL_ROWS;
    for (;;) {
        if ((current & BVH_LEAF) == 0u) {
            const global BvhNode *node = nodes + current;
            float8 enter;
            const uint bits = mask_bits(LEVEL(children_of_packet)(node, packet, &enter));
            const uint8 lane = (uint8)(0, 1, 2, 3, 4, 5, 6, 7);
            store_picked(*(const global uint8 *)node->child, bits, children + size);
            store_picked(lane | (uint8)(current << 3), bits, places + size);
            size += popcount(bits);
        } else {
            LEAF_ENDS_RAYS(scene, group, current >> BVH_KIND_SHIFT & 7u, current & BVH_BLOCK, rows, packet);
            if (all_ended(packet)) return;
        }
        do {
            if (size == 0u) return;
            --size;
            rows = LEVEL(rows_entering)(nodes + (places[size] >> 3), places[size] & 7u, packet);
        } while (rows == 0u);
        current = children[size];
    }
}
#undef BVH_STACK
