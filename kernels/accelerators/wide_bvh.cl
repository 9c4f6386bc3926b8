// Template, included once per level: LEVEL(name) names its functions, the LEAF_ macros test one block.
// Bounding volume hierarchy of 8 children per node: one ray against 8 boxes at a time.
#include "kernels/accelerators/wide_bvh.h"

#define BVH_STACK (BVH_PENDING + BVH_WIDTH)

/// Bits of the children whose boxes the ray meets before t_max, and where it enters each (never negative).
FUNCTION uint LEVEL(children)(const global BvhNode *node, const ray_x8 *ray, float8 *enter) {
    const vec3x8 inverse = ray->inverse;
    const bool x = inverse.x.s0 < 0.0f, y = inverse.y.s0 < 0.0f, z = inverse.z.s0 < 0.0f;
#define PLANE(side, axis) (*(const global float8 *)(side)[axis])
    const float8 near_x = fma(PLANE(x ? node->high : node->low, 0), inverse.x, x ? ray->shift_high.x : ray->shift_low.x);
    const float8 near_y = fma(PLANE(y ? node->high : node->low, 1), inverse.y, y ? ray->shift_high.y : ray->shift_low.y);
    const float8 near_z = fma(PLANE(z ? node->high : node->low, 2), inverse.z, z ? ray->shift_high.z : ray->shift_low.z);
    const float8 far_x = fma(PLANE(x ? node->low : node->high, 0), inverse.x, x ? ray->shift_low.x : ray->shift_high.x);
    const float8 far_y = fma(PLANE(y ? node->low : node->high, 1), inverse.y, y ? ray->shift_low.y : ray->shift_high.y);
    const float8 far_z = fma(PLANE(z ? node->low : node->high, 2), inverse.z, z ? ray->shift_low.z : ray->shift_high.z);
#undef PLANE
    const float8 near = maximum(maximum(near_x, near_y), maximum(near_z, (float8)(0.0f)));
    const float8 far = minimum(minimum(far_x, far_y), minimum(far_z, ray->t_max));
    *enter = near;
    return mask_bits(near <= far);
}

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
            uint bits = LEVEL(children)(node, ray, &enter);
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
            uint bits = LEVEL(children)(nodes + current, ray, &enter);
            for (; bits != 0u; bits &= bits - 1u) stack[size++] = nodes[current].child[lowest_bit(bits)];
        } else if (LEAF_ANY_HIT(scene, group, current >> BVH_KIND_SHIFT & 7u, current & BVH_BLOCK, ray, list)) {
            return true;
        }
        if (size == 0u) return false;
        current = stack[--size];
    }
}
#undef BVH_STACK
