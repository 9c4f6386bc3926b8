// Template, included once per level: LEVEL(name) names its functions, the LEAF_ macros test one block.
// Bounding volume hierarchy of 8 children per node: one ray against one box after another, with little memory of its own. The stack has one entry per
// level, a node and which of its children are still to be visited (as in Ylitie, Karras and Laine 2017). It knows no distances: a ray that comes back
// to a node looks again which of these children it still meets, and which is the nearest.
#include "kernels/accelerators/wide_bvh.h"

#include "kernels/core/lanes_1.cl"
#include "kernels/accelerators/wide_bvh_box.cl"

#define BVH_ALL_CHILDREN 0xffu
#define BVH_ENTRY(node, children) ((ulong)(node) << BVH_WIDTH | (children))

/// Of these children those that the ray meets before its t_max. `nearest` becomes the one that it enters first.
FUNCTION uint LEVEL(children_met)(const global BvhNode *node, const ray_x1 *ray, uint children, uint *nearest) {
    uint met = 0u;
    float first = INFINITY;
    for (uint c = 0u; c < BVH_WIDTH; ++c) {
        float enter;
        if ((children >> c & 1u) == 0u || !LEVEL(meets_child)(node, c, ray, &enter)) continue;
        if (met == 0u || enter < first) *nearest = c, first = enter;
        met |= 1u << c;
    }
    return met;
}

static void LEVEL(closest_hit)(Scene scene, const global Group *group, ray_x1 *ray, Nearest *nearest) {
    const global BvhNode *nodes = RECORDS(scene, BvhNode, group->nodes);
    ulong stack[BVH_LEVELS - 1u];
    uint size = 0u, current = 0u, children = BVH_ALL_CHILDREN;
    COUNT(ray, steps, 1u);
    for (;;) {
        uint child = 0u;
        children = LEVEL(children_met)(nodes + current, ray, children, &child);
        if (children != 0u) {
            children &= ~(1u << child);
            const uint word = nodes[current].child[child];
            COUNT(ray, steps, 1u), COUNT(ray, cells, (word & BVH_LEAF) != 0u);
            if ((word & BVH_LEAF) == 0u) {
                if (children != 0u) stack[size++] = BVH_ENTRY(current, children);
                current = word, children = BVH_ALL_CHILDREN;
                continue;
            }
            LEAF_CLOSEST_HIT(scene, group, word >> BVH_KIND_SHIFT & 7u, word & BVH_BLOCK, ray, nearest);
        }
        if (children == 0u) {
            if (size == 0u) return;
            current = (uint)(stack[--size] >> BVH_WIDTH), children = (uint)stack[size] & BVH_ALL_CHILDREN;
        }
    }
}

/// Adds all hits up to the ray's t_max to the list; without a list, tells whether there is any. The child with the fewest primitives is visited
/// first, which is the last one: it is the likeliest to be hit soon for its cost.
static bool LEVEL(any_hit)(Scene scene, const global Group *group, const ray_x1 *ray, HitList *list) {
    const global BvhNode *nodes = RECORDS(scene, BvhNode, group->nodes);
    ulong stack[BVH_LEVELS - 1u];
    uint size = 0u, current = 0u, nearest;
    COUNT(ray, steps, 1u);
    uint children = LEVEL(children_met)(nodes, ray, BVH_ALL_CHILDREN, &nearest);
    for (;;) {
        if (children == 0u) {
            if (size == 0u) return false;
            current = (uint)(stack[--size] >> BVH_WIDTH), children = (uint)stack[size] & BVH_ALL_CHILDREN;
        }
        const uint child = 31u - clz(children), word = nodes[current].child[child];
        children &= ~(1u << child);
        COUNT(ray, steps, 1u), COUNT(ray, cells, (word & BVH_LEAF) != 0u);
        if ((word & BVH_LEAF) == 0u) {
            if (children != 0u) stack[size++] = BVH_ENTRY(current, children);
            current = word, children = LEVEL(children_met)(nodes + current, ray, BVH_ALL_CHILDREN, &nearest);
        } else if (LEAF_ANY_HIT(scene, group, word >> BVH_KIND_SHIFT & 7u, word & BVH_BLOCK, ray, list)) {
            return true;
        }
    }
}
#undef BVH_ALL_CHILDREN
#undef BVH_ENTRY
