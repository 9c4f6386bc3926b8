// Template, included once per level: LEVEL(name) names its functions, the LEAF_ macros test one block.
// Bounding volume hierarchy of 8 children per node: one ray against 8 boxes at a time.
#include "kernels/accelerators/wide_bvh.h"

#include "kernels/core/lanes_8.cl"
#include "kernels/accelerators/wide_bvh_box.cl"

#include "kernels/core/lanes_1.cl"

#define BVH_STACK (BVH_PENDING + BVH_WIDTH)

/// The stack holds children with the t where the ray enters them, as (bits of t) << 32 | child, farthest first among the children of a node.
static void LEVEL(closest_hit)(Scene scene, const global Group *group, ray_x8 *ray, Nearest *nearest) {
    const global BvhNode *nodes = RECORDS(scene, BvhNode, group->nodes);
    ulong stack[BVH_STACK];
    uint size = 0u, current = 0u;
    for (;;) {
        COUNT(ray, steps, 1u), COUNT(ray, cells, (current & BVH_LEAF) != 0u);
        if ((current & BVH_LEAF) == 0u) {
            const global BvhNode *node = nodes + current;
            float8 enter;
            uint bits = mask_bits(LEVEL(meets_child)(node, 0u, ray, &enter));
            if (bits != 0u) {
                float t[BVH_WIDTH];
                vstore8(enter, 0, t);
                const uint bottom = size;
                uint child = lowest_bit(bits);
                ulong first = (ulong)as_uint(t[child]) << 32 | node->child[child];
                for (bits &= bits - 1u; bits != 0u; bits &= bits - 1u) {
                    child = lowest_bit(bits);
                    ulong entry = (ulong)as_uint(t[child]) << 32 | node->child[child];
                    if (entry < first) {
                        const ulong swap = entry;
                        entry = first, first = swap;
                    }
                    uint place = size++;
                    for (; place > bottom && stack[place - 1u] < entry; --place) stack[place] = stack[place - 1u];
                    stack[place] = entry;
                }
                current = (uint)first;
                continue;
            }
        } else {
            LEAF_CLOSEST_HIT(scene, group, current >> BVH_KIND_SHIFT & 7u, current & BVH_BLOCK, ray, nearest);
        }
        do {
            if (size == 0u) return;
            current = (uint)stack[--size];
        } while ((uint)(stack[size] >> 32) > as_uint(ray->t_max.s0));
    }
}

/// Adds all hits up to the ray's t_max to the list; without a list, tells whether there is any. The child with the fewest primitives is
/// visited first: it is the likeliest to be hit soon for its cost.
static bool LEVEL(any_hit)(Scene scene, const global Group *group, const ray_x8 *ray, HitList *list) {
    const global BvhNode *nodes = RECORDS(scene, BvhNode, group->nodes);
    uint stack[BVH_STACK];
    uint size = 0u, current = 0u;
    for (;;) {
        COUNT(ray, steps, 1u), COUNT(ray, cells, (current & BVH_LEAF) != 0u);
        if ((current & BVH_LEAF) == 0u) {
            float8 enter;
            uint bits = mask_bits(LEVEL(meets_child)(nodes + current, 0u, ray, &enter));
            for (; bits != 0u; bits &= bits - 1u) stack[size++] = nodes[current].child[lowest_bit(bits)];
        } else if (LEAF_ANY_HIT(scene, group, current >> BVH_KIND_SHIFT & 7u, current & BVH_BLOCK, ray, list)) {
            return true;
        }
        if (size == 0u) return false;
        current = stack[--size];
    }
}
#undef BVH_STACK
