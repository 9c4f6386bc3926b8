// Template, included once per level: LEVEL(name) names its functions, the LEAF_ macros test one block.
// Bounding volume hierarchy of 8 children per node: a packet against one box after another.
#include "kernels/accelerators/wide_bvh.h"

#define BVH_STACK (BVH_PENDING + BVH_WIDTH)

/// Bits of the packet's rays that meet child `c` before their t_max, and where they enter it; rays that don't have +∞.
FUNCTION uint LEVEL(rays_entering)(const global BvhNode *node, uint c, const ray_x16 *ray, float16 *enter) {
#define AT(side, axis, component, shift) fma((float16)(node->side[axis][c]), ray->inverse.component, ray->shift.component)
    const vec3x16 a = make3(AT(low, 0, x, shift_low), AT(low, 1, y, shift_low), AT(low, 2, z, shift_low));
    const vec3x16 b = make3(AT(high, 0, x, shift_high), AT(high, 1, y, shift_high), AT(high, 2, z, shift_high));
#undef AT
    const vec3x16 nears = minimum(a, b), fars = maximum(a, b);
    const float16 near = maximum(maximum(nears.x, nears.y), maximum(nears.z, (float16)(0.0f)));
    const float16 far = minimum(minimum(fars.x, fars.y), minimum(fars.z, ray->t_max));
    const int16 meets = near <= far;
    *enter = meets ? near : (float16)(INFINITY);
    return mask_bits(meets);
}

/// Bits of the children that the packet may meet.
FUNCTION uint LEVEL(children_of_packet)(const global BvhNode *node, const PacketRays *packet) {
#define PLANES(side) make3(*(const global float8 *)(side)[0], *(const global float8 *)(side)[1], *(const global float8 *)(side)[2])
    box_x8 box;
    box.low = PLANES(node->low), box.high = PLANES(node->high);
#undef PLANES
    return candidates(packet, node->child, box);
}

/// Children are visited in the order of the first ray that tells them apart.
static void LEVEL(closest_hits)(Scene scene, const global Group *group, PacketRays *packet, PacketHits *hits) {
    const global BvhNode *nodes = RECORDS(scene, BvhNode, group->nodes);
    uint stack[BVH_STACK];
    float16 entered[BVH_STACK];
    uint size = 0u, current = 0u;
    for (;;) {
        if ((current & BVH_LEAF) == 0u) {
            const global BvhNode *node = nodes + current;
            uint nearest = BVH_EMPTY;
            float16 nearest_enter = (float16)(INFINITY);
            for (uint bits = LEVEL(children_of_packet)(node, packet); bits != 0u; bits &= bits - 1u) {
                const uint c = lowest_bit(bits);
                float16 enter;
                if (LEVEL(rays_entering)(node, c, &packet->rays, &enter) == 0u) continue;
                if (nearest == BVH_EMPTY) {
                    nearest = node->child[c], nearest_enter = enter;
                } else if (mask_bits(enter < nearest_enter) != 0u) {
                    stack[size] = nearest, entered[size++] = nearest_enter;
                    nearest = node->child[c], nearest_enter = enter;
                } else {
                    stack[size] = node->child[c], entered[size++] = enter;
                }
            }
            if (nearest != BVH_EMPTY) {
                current = nearest;
                continue;
            }
        } else {
            LEAF_CLOSEST_HITS(scene, group, current >> BVH_KIND_SHIFT & 7u, current & BVH_BLOCK, packet, hits);
        }
        do {
            if (size == 0u) return;
            current = stack[--size];
        } while (mask_bits(entered[size] <= packet->rays.t_max) == 0u);
    }
}

/// Ends every ray that meets something: its t_max becomes -1.
static void LEVEL(end_occluded)(Scene scene, const global Group *group, PacketRays *packet) {
    const global BvhNode *nodes = RECORDS(scene, BvhNode, group->nodes);
    uint stack[BVH_STACK];
    uint size = 0u, current = 0u;
    for (;;) {
        if ((current & BVH_LEAF) == 0u) {
            const global BvhNode *node = nodes + current;
            float16 enter;
            for (uint bits = LEVEL(children_of_packet)(node, packet); bits != 0u; bits &= bits - 1u) {
                const uint c = lowest_bit(bits);
                if (LEVEL(rays_entering)(node, c, &packet->rays, &enter) != 0u) stack[size++] = node->child[c];
            }
        } else {
            LEAF_ENDS_RAYS(scene, group, current >> BVH_KIND_SHIFT & 7u, current & BVH_BLOCK, packet);
            if (mask_bits(packet->rays.t_max >= 0.0f) == 0u) return;
        }
        if (size == 0u) return;
        current = stack[--size];
    }
}
#undef BVH_STACK
