// Template, included once per level: LEVEL(name) names its functions, the LEAF_ macros test one block.
// Hierarchy of bounding volumes (Rubin and Whitted, A 3-Dimensional Representation for Fast Rendering of Complex Scenes, SIGGRAPH 1980) of several
// shapes (Weghorst, Hooper and Greenberg, Improved Computational Methods for Ray Tracing, ACM TOG 3(1) 1984): one ray against one volume at a time,
// the nearer of two children first (Kay and Kajiya, Ray Tracing Complex Scenes, SIGGRAPH 1986).
// The order goes by boxes alone: a hit is never before the entry into its primitive's own box (lane_ray.cl), but may be before that into a tighter
// one.
#include "kernels/accelerators/volumes.cl"

/// Where the ray enters the node, never negative; infinite if it misses the node's box before its t_max, or the volume in it.
FUNCTION float LEVEL(enter)(const global VolumeNode *node, const global Volume *volumes, const ray_x8 *ray, Line line) {
    const Stretch stretch = stretch_in_box(node->low, node->high, ray);
    const float enter = maximum(stretch.near, 0.0f);
    const bool meets = enter <= minimum(stretch.far, ray->t_max.s0) &&
                       meets_volume(node->volume & 7u, volumes + (node->volume >> VOLUME_PLACE_SHIFT), line, stretch);
    COUNT(ray, steps, 1u), COUNT(ray, missed, !meets);
    return meets ? enter : INFINITY;
}

#define TREE (RECORDS(scene, VolumeTree, group->nodes))
#define NODES ((const global VolumeNode *)(TREE + 1))
#define VOLUMES ((const global Volume *)(NODES + TREE->node_count))

static void LEVEL(closest_hit)(Scene scene, const global Group *group, ray_x8 *ray, Nearest *nearest) {
    const global VolumeNode *nodes = NODES;
    const global Volume *volumes = VOLUMES;
    const Line line = line_of(ray);
    ulong stack[VOLUME_STACK];  // (bits of t) << 32 | node
    uint size = 0u, current = 0u;
    if (TREE->node_count == 0u || LEVEL(enter)(nodes, volumes, ray, line) == INFINITY) return;
    for (;;) {
        const uint children = nodes[current].children;
        if ((children & VOLUME_LEAF) != 0u) {
            const float t = nearest->hit.t;
            COUNT(ray, cells, 1u);
            LEAF_CLOSEST_HIT(scene, group, children >> VOLUME_KIND_SHIFT & 7u, children & VOLUME_BLOCK, ray, nearest);
            COUNT(ray, served, nearest->hit.t < t), COUNT(ray, idle, !(nearest->hit.t < t));
        } else {
            const float first = LEVEL(enter)(nodes + children, volumes, ray, line), second = LEVEL(enter)(nodes + children + 1u, volumes, ray, line);
            const bool swap = second < first;
            const float near = swap ? second : first, far = swap ? first : second;
            if (far < INFINITY) stack[size++] = (ulong)as_uint(far) << 32 | (children + !swap);
            if (near < INFINITY) {
                current = children + swap;
                continue;
            }
        }
        do {
            if (size == 0u) return;
            current = (uint)stack[--size];
        } while ((uint)(stack[size] >> 32) > as_uint(ray->t_max.s0));
    }
}

/// Adds all hits up to the ray's t_max to the list; without a list, tells whether there is any.
static bool LEVEL(any_hit)(Scene scene, const global Group *group, const ray_x8 *ray, HitList *list) {
    const global VolumeNode *nodes = NODES;
    const global Volume *volumes = VOLUMES;
    const Line line = line_of(ray);
    uint stack[VOLUME_STACK];
    uint size = 0u;
    if (TREE->node_count > 0u) stack[size++] = 0u;
    while (size > 0u) {
        const uint current = stack[--size], children = nodes[current].children;
        if (LEVEL(enter)(nodes + current, volumes, ray, line) == INFINITY) continue;
        if ((children & VOLUME_LEAF) == 0u) {
            stack[size++] = children + 1u, stack[size++] = children;
            continue;
        }
        COUNT(ray, cells, 1u);
        const bool found = LEAF_ANY_HIT(scene, group, children >> VOLUME_KIND_SHIFT & 7u, children & VOLUME_BLOCK, ray, list);
        COUNT(ray, served, found), COUNT(ray, idle, !found);
        if (found) return true;
    }
    return false;
}
#undef TREE
#undef NODES
#undef VOLUMES
