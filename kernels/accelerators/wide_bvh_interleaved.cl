// Bounding volume hierarchy of 8 children per node: rays that take turns.
#include "kernels/accelerators/wide_bvh.h"
#include "kernels/core/lane_order.cl"

/// A ray meets what its stack holds from the end on; above BVH_PENDING entries there is room for the children of a node. In an instance it goes on
/// above those of the world, and of a block of instances.
#define BVH_STACK (INSTANCES ? 2u * (BVH_PENDING + BVH_WIDTH) + BLOCK_SIZE : BVH_PENDING + BVH_WIDTH)

/// A word's upper four bits tell what it stands for: a node, or a block of one of the kinds.
#define BVH_TARGET_SHIFT BVH_KIND_SHIFT
#define BVH_TARGETS 16u
#define BVH_INSTANCE 0x40000000u  ///< or for an instance: its lane in bits 0..2, above them its block
#define BVH_LEAVE 0x50000000u     ///< or lies below what a ray has met in an instance,
#define BVH_THROUGH 0x60000000u   ///< or below all

/// Nodes, or blocks of one kind.
typedef struct {
    ulong address;    ///< of the first in the world
    uint size, next;  ///< bytes of each; NEXT_...
} Target;

typedef struct {
    Scene scene;
    const global Group *world;
    const global BvhNode *nodes;  ///< its
    Target targets[BVH_TARGETS];
} Course;

typedef struct {
    const PreparedRays *rays;
    uint lane;    ///< of them
    uint number;  ///< the caller's own
    float t_max;
    uint size;  ///< of the stack
    Nearest nearest;
    uint children[1u + BVH_STACK];       ///< the stack, above BVH_THROUGH
    int entered[BVH_WIDTH + BVH_STACK];  ///< bits of the t where it enters a child, but for the last three: not above it; the first 8 are below all
    // In scenes with instances:
    const global Group *group;  ///< where it is: the world, or an instance's group
    const global BvhNode *nodes;
    const PreparedRays *world_rays;
    uint world_lane;
    PreparedRays *inside;  ///< the ray in an instance's space is lane `place` of these
    uint place;
} Traversal;

FUNCTION Course course_of(Scene scene) {
    const global Group *world = &scene.header->world;
    Course course;
    course.scene = scene, course.world = world, course.nodes = RECORDS(scene, BvhNode, world->nodes);
    for (uint target = 0u; target < BVH_TARGETS; ++target)
        course.targets[target] = (Target){(ulong)course.nodes, sizeof(BvhNode), target < BVH_LEAF >> BVH_TARGET_SHIFT ? NEXT_NODE : NEXT_LEAF};
    course.targets[BVH_INSTANCE >> BVH_TARGET_SHIFT].next = NEXT_INSTANCE;
    course.targets[BVH_LEAVE >> BVH_TARGET_SHIFT].next = NEXT_LEAVE;
    course.targets[BVH_THROUGH >> BVH_TARGET_SHIFT].next = NEXT_THROUGH;
#define TARGET(KIND, Record, name)                            \
    course.targets[(BVH_LEAF >> BVH_TARGET_SHIFT) + (KIND)] = \
        (Target){(ulong)RECORDS(scene, Record##Block, world->blocks[KIND]), sizeof(Record##Block), KIND == INSTANCE_KIND ? NEXT_BLOCK : NEXT_LEAF};
    WORLD_KINDS(TARGET)
#undef TARGET
    return course;
}

/// Where the traversal is.
FUNCTION const global Group *group_here(const Course *course, const Traversal *traversal) { return INSTANCES ? traversal->group : course->world; }
FUNCTION const global BvhNode *nodes_here(const Course *course, const Traversal *traversal) { return INSTANCES ? traversal->nodes : course->nodes; }

FUNCTION void begin(const Course *course, Traversal *traversal, const PreparedRays *rays, uint lane) {
    traversal->rays = rays, traversal->lane = lane;
    traversal->t_max = LANE_OF(rays->rays.t_max, lane);
    traversal->size = 1u;
    traversal->children[0] = BVH_THROUGH, traversal->children[1] = 0u;
    vstore8((int8)(INT_MIN), 0, traversal->entered);
    traversal->entered[BVH_WIDTH] = 0;
    if (!INSTANCES) return;
    traversal->group = course->world, traversal->nodes = course->nodes;
    traversal->world_rays = rays, traversal->world_lane = lane;
}

FUNCTION void closest_begin(const Course *course, Traversal *traversal, const PreparedRays *rays, uint lane, Ray ray) {
    begin(course, traversal, rays, lane);
    traversal->nearest = nothing_hit(ray, course->world->extent);
    SET_TIME(traversal->nearest, LANE_TIME(rays->rays, lane));
}

FUNCTION void any_begin(const Course *course, Traversal *traversal, const PreparedRays *rays, uint lane) {
    begin(course, traversal, rays, lane);
    traversal->nearest.hit.primitive = NO_HIT;
}

/// Which children of the node the ray meets before t_max, and where it enters them, never negative.
FUNCTION int8 children_met(const global BvhNode *node, const Traversal *traversal, float8 *enter) {
    const PreparedRays *rays = traversal->rays;
    const uint lane = traversal->lane;
    const global float *planes = node->low[0];
#define T(side, axis)                                                                                                                    \
    fma(*(const global float8 *)(planes + (uint)NUMBER_OF(rays->side##_##axis, lane)), (float8)(LANE_OF(rays->rays.inverse.axis, lane)), \
        (float8)(LANE_OF(rays->side##_shift.axis, lane)))
    *enter = maximum(maximum(T(near, x), T(near, y)), maximum(T(near, z), (float8)(0.0f)));
    return *enter <= minimum(minimum(T(far, x), T(far, y)), minimum(T(far, z), (float8)(traversal->t_max)));
#undef T
}

/// How many of the first `size` children on the stack are left when those at its end that the ray enters beyond t_max have gone.
FUNCTION uint size_before(const Traversal *traversal, uint size, float t_max) {
    for (;; size -= BVH_WIDTH) {
        const uint near = mask_bits((vload8(0, traversal->entered + size) & (int8)(~7)) <= (int8)(as_int(t_max)));
        if (near != 0u) return size + 24u - clz(near);
    }
}

/// In place of the last child on the stack come those that are met, the nearest last; if none is, `rest` children are left.
FUNCTION void push_nearest_last(Traversal *traversal, uint rest, int8 met, float8 enter, uint8 children) {
    const uint size = traversal->size - 1u;
    const int8 lane = (int8)(0, 1, 2, 3, 4, 5, 6, 7);
    const uint bits = mask_bits(met), count = popcount(bits);
    const int8 order = sorted(met ? (as_int8(enter) & (int8)(~7)) | lane : (int8)(-1), bits);
    vstore8(order, 0, traversal->entered + BVH_WIDTH + size);
    vstore8(picked(children, as_uint8(order)), 0, traversal->children + 1u + size);
    traversal->size = count != 0u ? size + count : rest;
}

/// The same in their order.
FUNCTION void push(Traversal *traversal, uint met, uint8 children) {
    store_picked(children, met, traversal->children + traversal->size);
    traversal->size += popcount(met) - 1u;
}

#include "generated/interleaved_levels.cl"

/// All of it, a triangle block's five lines or fewer, is on its way to the processor when the ray makes its step. A hint that changes nothing.
FUNCTION uint upcoming(const Course *course, const Traversal *traversal) {
    const uint word = traversal->children[traversal->size];
#if __has_builtin(__builtin_prefetch)
    const ulong address = address_of(course, traversal, word);
    const ulong last = address + course->targets[word >> BVH_TARGET_SHIFT].size - 64u;
#pragma unroll
    for (uint line = 0u; line < 4u; ++line) __builtin_prefetch((const void *)(address + 64u * line), 0, 3);
    __builtin_prefetch((const void *)last, 0, 3);
#endif
    return word;
}

FUNCTION uint next_of(const Course *course, uint word) { return course->targets[word >> BVH_TARGET_SHIFT].next; }
FUNCTION bool is_node(uint word) { return word < BVH_INSTANCE; }
FUNCTION bool is_leaf(uint word) { return word >= BVH_LEAF; }
FUNCTION bool is_through(uint word) { return word == BVH_THROUGH; }

FUNCTION void closest_node_step(const Course *course, Traversal *traversal) {
    const uint rest = size_before(traversal, traversal->size - 1u, traversal->t_max);
    const global BvhNode *node = nodes_here(course, traversal) + traversal->children[traversal->size];
    float8 enter;
    const int8 met = children_met(node, traversal, &enter);
    push_nearest_last(traversal, rest, met, enter, *(const global uint8 *)node->child);
}

FUNCTION void closest_leaf_step(const Course *course, Traversal *traversal) {
    const uint word = traversal->children[traversal->size];
    ray_x8 ray = widened(traversal->rays, traversal->lane, traversal->t_max);
    block_closest_hit(course->scene, group_here(course, traversal), word >> BVH_KIND_SHIFT & 7u, word & BVH_BLOCK, &ray, &traversal->nearest);
    traversal->t_max = ray.t_max.s0;
    traversal->size = size_before(traversal, traversal->size - 1u, traversal->t_max);
}

/// The children with the fewest primitives come first, as in any_hit.
FUNCTION void any_node_step(const Course *course, Traversal *traversal) {
    const global BvhNode *node = nodes_here(course, traversal) + traversal->children[traversal->size];
    float8 enter;
    const int8 met = children_met(node, traversal, &enter);
    push(traversal, mask_bits(met), *(const global uint8 *)node->child);
}

FUNCTION void any_leaf_step(const Course *course, Traversal *traversal) {
    const uint word = traversal->children[traversal->size];
    const ray_x8 ray = widened(traversal->rays, traversal->lane, traversal->t_max);
    const bool hit = block_any_hit(course->scene, group_here(course, traversal), word >> BVH_KIND_SHIFT & 7u, word & BVH_BLOCK, &ray, 0);
    traversal->nearest.hit.primitive = hit ? 0u : NO_HIT;
    traversal->size = hit ? 0u : traversal->size - 1u;
}
