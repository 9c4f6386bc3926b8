// Bounding volume hierarchy of 8 children per node: rays that take turns.
#include "kernels/accelerators/wide_bvh.h"
#include "kernels/core/lane_order.cl"

/// A ray meets what its stack holds from the end on; above BVH_PENDING entries there is room for the children of a node.
#define BVH_STACK (BVH_PENDING + BVH_WIDTH)

/// A word's upper four bits tell what it stands for: a node, or a block of one of the kinds.
#define BVH_TARGET_SHIFT BVH_KIND_SHIFT
#define BVH_TARGETS 16u

/// Nodes, or blocks of one kind.
typedef struct {
    ulong address, size;  ///< of the first, and of each [bytes]
} Target;

typedef struct {
    Scene scene;
    const global Group *world;
    const global BvhNode *nodes;
    Target targets[BVH_TARGETS];
} Course;

typedef struct {
    const PreparedRays *rays;
    uint lane;    ///< of them
    uint number;  ///< the caller's own
    float t_max;
    uint size;  ///< of the stack
    Nearest nearest;
    uint children[1u + BVH_STACK];  ///< the stack, from the second on; the first is any word
    int entered[BVH_WIDTH +
                BVH_STACK];  ///< bits of the t where the ray enters a child, but for the last three: not above it; the first 8 are below all
} Traversal;

FUNCTION Course course_of(Scene scene) {
    const global Group *world = &scene.header->world;
    Course course;
    course.scene = scene, course.world = world, course.nodes = RECORDS(scene, BvhNode, world->nodes);
    for (uint target = 0u; target < BVH_TARGETS; ++target) course.targets[target] = (Target){(ulong)course.nodes, sizeof(BvhNode)};
#define TARGET(KIND, Record, name)                            \
    course.targets[(BVH_LEAF >> BVH_TARGET_SHIFT) + (KIND)] = \
        (Target){(ulong)RECORDS(scene, Record##Block, world->blocks[KIND]), sizeof(Record##Block)};
    WORLD_KINDS(TARGET)
#undef TARGET
    return course;
}

FUNCTION void begin(const Course *course, Traversal *traversal, const PreparedRays *rays, uint lane) {
    traversal->rays = rays, traversal->lane = lane;
    traversal->t_max = LANE_OF(rays->rays.t_max, lane);
    traversal->size = 1u;
    traversal->children[0] = 0u, traversal->children[1] = 0u;
    vstore8((int8)(INT_MIN), 0, traversal->entered);
    traversal->entered[BVH_WIDTH] = 0;
    const ray_x8 wide = widened(rays, lane, traversal->t_max);
    traversal->nearest = nothing_hit(&wide);
}

FUNCTION bool is_through(const Traversal *traversal) { return traversal->size == 0u; }

FUNCTION bool is_node(uint word) { return (word & BVH_LEAF) == 0u; }

/// All of it is on its way to the processor when the ray's turn comes again. A hint that changes nothing.
FUNCTION void fetch(const Course *course, uint word) {
#if __has_builtin(__builtin_prefetch)
    const Target target = course->targets[word >> BVH_TARGET_SHIFT];
    const ulong address = target.address + (ulong)(word & BVH_BLOCK) * target.size;
#pragma unroll
    for (uint line = 0u; line < 5u; ++line) __builtin_prefetch((const void *)(address + 64u * line), 0, 3);
#endif
}

FUNCTION uint upcoming(const Course *course, const Traversal *traversal) {
    const uint word = traversal->children[traversal->size];
    fetch(course, word);
    return word;
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

/// Its children are put on the stack, the nearest last.
FUNCTION void closest_node_step(const Course *course, Traversal *traversal) {
    const uint size = traversal->size - 1u, rest = size_before(traversal, size, traversal->t_max);
    const global BvhNode *node = course->nodes + traversal->children[traversal->size];
    float8 enter;
    const int8 met = children_met(node, traversal, &enter);
    const int8 lane = (int8)(0, 1, 2, 3, 4, 5, 6, 7);
    const int8 order = sorted(met ? (as_int8(enter) & (int8)(~7)) | lane : (int8)(-1));
    vstore8(order, 0, traversal->entered + BVH_WIDTH + size);
    vstore8(picked(*(const global uint8 *)node->child, as_uint8(order)), 0, traversal->children + 1u + size);
    const uint count = popcount(mask_bits(met));
    traversal->size = count != 0u ? size + count : rest;
}

FUNCTION void closest_leaf_step(const Course *course, Traversal *traversal) {
    const uint word = traversal->children[traversal->size];
    ray_x8 ray = widened(traversal->rays, traversal->lane, traversal->t_max);
    WORLD_CLOSEST_HIT(course->scene, course->world, word >> BVH_KIND_SHIFT & 7u, word & BVH_BLOCK, &ray, &traversal->nearest);
    traversal->t_max = ray.t_max.s0;
    traversal->size = size_before(traversal, traversal->size - 1u, traversal->t_max);
}

/// The children with the fewest primitives come first, as in any_hit.
FUNCTION void any_node_step(const Course *course, Traversal *traversal) {
    const uint size = traversal->size - 1u;
    const global BvhNode *node = course->nodes + traversal->children[traversal->size];
    float8 enter;
    const uint bits = mask_bits(children_met(node, traversal, &enter));
    store_picked(*(const global uint8 *)node->child, bits, traversal->children + 1u + size);
    traversal->size = size + popcount(bits);
}

FUNCTION void any_leaf_step(const Course *course, Traversal *traversal) {
    const uint word = traversal->children[traversal->size];
    const ray_x8 ray = widened(traversal->rays, traversal->lane, traversal->t_max);
    const bool hit = WORLD_ANY_HIT(course->scene, course->world, word >> BVH_KIND_SHIFT & 7u, word & BVH_BLOCK, &ray, 0);
    traversal->nearest.hit.primitive = hit ? 0u : NO_HIT;
    traversal->size = hit ? 0u : traversal->size - 1u;
}
