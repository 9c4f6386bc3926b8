// The leaves of a kd-tree along a ray, nearest first: Kaplan's BSP tree (The Uses of Spatial Coherence in Ray Tracing, SIGGRAPH 1985 course notes) in
// the recursion of Jansen (Data Structures for Ray Tracing, 1986) with a stack of one's own, which Havran calls TA_rec^B (Heuristic Ray Shooting
// Algorithms, thesis, Prague 2000, section 4.2).
//
// As there, the ray is in a node's box from t `enter` to `leave`, and a plane cuts that into the near child's part and the far one's. But the plane
// is as thick as rounding makes it: the near child is left a little after the far one is entered, by the pad of the boxes' test (lane_ray.cl). Where
// the ray comes to the plane outside of `enter` to `leave`, it meets one child alone.
//
// No hit of `none` is lost: it counts only if the ray meets the primitive's own box, say from t on, and lies at t or later. Of the children whose
// lists have the primitive one is met at t too, since its planes are computed as the sides of that box are, by one formula, which is monotone: if
// the box lies on one side of the plane, the ray cannot leave that side before t, nor enter it after; if it lies on both, t lies before the far one
// is entered or after, and so in one of their parts. So it goes down to a leaf, which is dropped only if entered behind t_max, while the hit is not.
#pragma once
#include "kernels/accelerators/kd_tree.h"
#include "kernels/core/rays.cl"

/// What a ray knows of an axis.
typedef struct {
    float inverse, near, far;  ///< plane -> t where what is beyond is entered, and where what is before is left: fma(plane, inverse, near or far)
    uint backward;             ///< 1: the ray comes to the upper child first
} KdAxis;

/// A node, and the t of the ray's part in it.
typedef struct {
    uint node;
    float enter, leave;
} KdPart;

typedef struct {
    KdAxis axes[3];
    const global KdNode *nodes;
    KdPart stack[KD_DEPTH + 1u];  ///< what is to come, nearest last
    uint size;
} CellWalk;

FUNCTION KdAxis kd_axis(float inverse, float shift_low, float shift_high) {
    const bool backward = inverse < 0.0f;
    const KdAxis axis = {inverse, backward ? shift_high : shift_low, backward ? shift_low : shift_high, backward ? 1u : 0u};
    return axis;
}

/// t where the ray enters the slab from `low` to `high`, and where it leaves it.
FUNCTION float slab_enter(const KdAxis *axis, float low, float high) { return fma(axis->backward ? high : low, axis->inverse, axis->near); }
FUNCTION float slab_leave(const KdAxis *axis, float low, float high) { return fma(axis->backward ? low : high, axis->inverse, axis->far); }

FUNCTION void cell_walk_begin(CellWalk *walk, const global CellSpans *spans, const ray_x8 *ray) {
    const global KdTree *tree = (const global KdTree *)spans;
    walk->nodes = (const global KdNode *)((const global uint *)spans + spans->cells);
    KdAxis *x = walk->axes, *y = walk->axes + 1, *z = walk->axes + 2;
    *x = kd_axis(ray->inverse.x.s0, ray->shift_low.x.s0, ray->shift_high.x.s0);
    *y = kd_axis(ray->inverse.y.s0, ray->shift_low.y.s0, ray->shift_high.y.s0);
    *z = kd_axis(ray->inverse.z.s0, ray->shift_low.z.s0, ray->shift_high.z.s0);
#define OF_SLABS(least, slab) least(slab(x, tree->low.x, tree->high.x), least(slab(y, tree->low.y, tree->high.y), slab(z, tree->low.z, tree->high.z)))
    const KdPart root = {0u, maximum(0.0f, OF_SLABS(maximum, slab_enter)), minimum(ray->t_max.s0, OF_SLABS(minimum, slab_leave))};
#undef OF_SLABS
    walk->stack[0] = root;
    walk->size = root.enter <= root.leave ? 1u : 0u;
}

/// Goes down to the first leaf, and leaves what comes later on the stack. Gives the leaf.
FUNCTION uint first_leaf(CellWalk *walk, KdPart part, const ray_x8 *ray) {
    for (;;) {
        COUNT(ray, steps, 1u);
        const KdNode node = walk->nodes[part.node];
        if ((node.word & KD_AXIS) == KD_LEAF) return node.plane;
        const KdAxis *axis = walk->axes + (node.word & KD_AXIS);
        const float enter = fma(as_float(node.plane), axis->inverse, axis->near), leave = fma(as_float(node.plane), axis->inverse, axis->far);
        const uint near = (node.word >> KD_CHILD_SHIFT) + axis->backward, far = near ^ 1u;
        if (enter > part.leave) {
            part.node = near;
        } else if (leave < part.enter) {
            part.node = far;
        } else {
            const KdPart later = {far, maximum(enter, part.enter), part.leave};
            walk->stack[walk->size++] = later;
            part.node = near, part.leave = minimum(leave, part.leave);
        }
    }
}

FUNCTION uint cell_walk_next(CellWalk *walk, const ray_x8 *ray) {
    while (walk->size > 0u) {
        const KdPart part = walk->stack[--walk->size];
        if (part.enter > ray->t_max.s0) continue;
        const uint items = first_leaf(walk, part, ray);
        COUNT(ray, cells, 1u), COUNT(ray, empty_cells, items == NO_ITEMS);
        if (items != NO_ITEMS) return items;
    }
    return NO_ITEMS;
}
