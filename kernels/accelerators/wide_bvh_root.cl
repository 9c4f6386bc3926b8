// The root of the hierarchy for rows of rays, which share its boxes and primitives: where a scene has a few large ones, walls or a ground, these are
// among the root's children; and of the rays that leave an object many meet nothing there but air. The others go on below it one by one.
#pragma once
#include "kernels/accelerators/interleaved.cl"
#include "kernels/accelerators/rows.cl"

/// MEET for the block that a word stands for, if it is of this kind.
#define BLOCK_AT_ROOT(KIND, Record, name, MEET) \
    if (kind == KIND) MEET_BLOCK(KIND, Record, name, (word & BVH_BLOCK), MEET)

/// For words of such children; empty ones are the last.
#define FOR_EACH_BLOCK_AT_ROOT(root, word, kind)                                                    \
    for (uint c_ = 0u, word, kind; c_ < BVH_WIDTH && (word = (root)->child[c_]) != BVH_EMPTY; ++c_) \
        if (kind = word >> BVH_KIND_SHIFT & 7u, word >= BVH_LEAF)

FUNCTION void root_closest_hits(const Course *course, TracedRow *row, RowHits *hits) {
    const Scene scene = course->scene;
    const global Group *world = course->world;
    FOR_EACH_BLOCK_AT_ROOT(course->nodes, word, kind) {
#define TAKE_BLOCK(KIND, Record, name) BLOCK_AT_ROOT(KIND, Record, name, TAKE_CROSSING)
        FOR_EACH_PRIMITIVE(TAKE_BLOCK)
#undef TAKE_BLOCK
    }
}

/// Bits of the rays that meet a primitive among the root's children before their t_max.
FUNCTION uint root_occluded(const Course *course, TracedRow *row) {
    const Scene scene = course->scene;
    const global Group *world = course->world;
    const uint alive = mask_bits(row->rays.t_max >= 0.0f);
    FOR_EACH_BLOCK_AT_ROOT(course->nodes, word, kind) {
#define END_BLOCK(KIND, Record, name) BLOCK_AT_ROOT(KIND, Record, name, END_CROSSING)
        FOR_EACH_PRIMITIVE(END_BLOCK)
#undef END_BLOCK
    }
    return alive & mask_bits(row->rays.t_max < 0.0f);
}

/// Bits of the root's children that are nodes.
FUNCTION uint nodes_of_root(const Course *course) { return mask_bits(*(const global int8 *)course->nodes->child >= 0); }

/// Bits of the rays that meet one of these children of the root before their t_max: those of which children_met says so for one.
FUNCTION uint rays_meeting(const global BvhNode *root, uint children, const ray_x16 *ray) {
    const int16 x = ray->inverse.x < 0.0f, y = ray->inverse.y < 0.0f, z = ray->inverse.z < 0.0f;
    int16 met = (int16)(0);
    for (; children != 0u; children &= children - 1u) {
        const uint c = lowest_bit(children);
#define T(side, axis, component) fma((float16)(root->side[axis][c]), ray->inverse.component, ray->shift_##side.component)
        const vec3x16 low = make3(T(low, 0, x), T(low, 1, y), T(low, 2, z)), high = make3(T(high, 0, x), T(high, 1, y), T(high, 2, z));
#undef T
        const float16 near = maximum(where(x, high.x, low.x), maximum(where(y, high.y, low.y), where(z, high.z, low.z)));
        const float16 far = minimum(where(x, low.x, high.x), minimum(where(y, low.y, high.y), where(z, low.z, high.z)));
        met |= maximum(near, (float16)(0.0f)) <= minimum(far, ray->t_max);
    }
    return mask_bits(met);
}

/// The children of the root that are nodes, of which the ray meets one.
FUNCTION int8 nodes_met(const Course *course, const Traversal *traversal, uint8 *children, float8 *enter) {
    *children = *(const global uint8 *)course->nodes->child;
    return children_met(course->nodes, traversal, enter) & (as_int8(*children) >= 0);
}

/// Begins at these, where the ray has met the root's primitives: `hit` of them and `next`, as Nearest has them.
FUNCTION void closest_go_on(const Course *course, Traversal *traversal, const PreparedRays *rays, uint lane, Ray ray, Hit hit, float next) {
    closest_begin(course, traversal, rays, lane, ray);
    traversal->nearest.hit = hit, traversal->nearest.next = next;
    if (hit.primitive != NO_HIT) traversal->t_max = hit.t + traversal->nearest.margin;
    uint8 children;
    float8 enter;
    const int8 met = nodes_met(course, traversal, &children, &enter);
    push_nearest_last(traversal, 0u, met, enter, children);
}

/// The same for a ray that has met none.
FUNCTION void any_go_on(const Course *course, Traversal *traversal, const PreparedRays *rays, uint lane) {
    any_begin(course, traversal, rays, lane);
    uint8 children;
    float8 enter;
    const int8 met = nodes_met(course, traversal, &children, &enter);
    push(traversal, mask_bits(met), children);
}
