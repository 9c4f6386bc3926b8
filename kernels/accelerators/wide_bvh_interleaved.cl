// Bounding volume hierarchy of 8 children per node: rays that take turns. A step is a node or a block and ends with the fetch of what comes next.
// Rays decide little but which of the two it is, so that processors guess right: while the step of one ray waits for memory or for its own
// arithmetic, those of the next rays are under way.
#include "kernels/accelerators/wide_bvh.h"
#include "kernels/core/lane_order.cl"

/// A ray meets what its stack holds from the end on; above BVH_PENDING entries there is room for the children of a node.
#define BVH_STACK (BVH_PENDING + BVH_WIDTH)

/// A word's upper four bits tell what it stands for: a node, or a block of one of the kinds.
#define BVH_TARGET_SHIFT BVH_KIND_SHIFT
#define BVH_TARGETS 16u

typedef struct {
    Scene scene;
    const global Group *world;
    const global BvhNode *nodes;
    ulong addresses[BVH_TARGETS];  ///< of the first node, and of the first block of each kind
    uint sizes[BVH_TARGETS];       ///< [bytes]
} Course;

typedef struct {
    ray_x1 ray;
    vec3 near_shift, far_shift;   ///< as the ray's shifts, of the planes that it meets first and last
    uint near_x, near_y, near_z;  ///< rows of a node with the planes that it meets first
    uint current, size;
    Nearest nearest;
    uint children[BVH_STACK];
    int entered[BVH_STACK];  ///< bits of the t where the ray enters a child, but for the last three: not above it
} Traversal;

FUNCTION Course course_of(Scene scene) {
    const global Group *world = &scene.header->world;
    Course course;
    course.scene = scene, course.world = world, course.nodes = RECORDS(scene, BvhNode, world->nodes);
    for (uint target = 0u; target < BVH_TARGETS; ++target) course.addresses[target] = (ulong)course.nodes, course.sizes[target] = sizeof(BvhNode);
#define TARGET(KIND, Record, name)                                                                                         \
    course.addresses[(BVH_LEAF >> BVH_TARGET_SHIFT) + (KIND)] = (ulong)RECORDS(scene, Record##Block, world->blocks[KIND]); \
    course.sizes[(BVH_LEAF >> BVH_TARGET_SHIFT) + (KIND)] = sizeof(Record##Block);
    WORLD_KINDS(TARGET)
#undef TARGET
    return course;
}

FUNCTION void begin(const Course *course, Traversal *traversal, Ray ray, uint instance) {
    ray_x1 prepared = prepare_narrow(ray, course->world->extent);
    if (INSTANCES) prepared.source_instance = (int)instance;
    const vec3 low = prepared.shift_low, high = prepared.shift_high;
    const bool x = prepared.inverse.x < 0.0f, y = prepared.inverse.y < 0.0f, z = prepared.inverse.z < 0.0f;
    traversal->near_shift = make3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
    traversal->far_shift = make3(x ? low.x : high.x, y ? low.y : high.y, z ? low.z : high.z);
    traversal->near_x = x ? 3u : 0u, traversal->near_y = y ? 4u : 1u, traversal->near_z = z ? 5u : 2u;
    traversal->ray = prepared;
    traversal->current = 0u, traversal->size = 0u;
    traversal->nearest = nothing_hit(ray, course->world->extent);
}

/// Which children of the node the ray meets before t_max, and where it enters them, never negative.
FUNCTION int8 children_met(const global BvhNode *node, const Traversal *traversal, float8 *enter) {
    const ray_x1 *ray = &traversal->ray;
    const global float8 *planes = (const global float8 *)node;
#define T(row, axis, shift) fma(planes[row], (float8)(ray->inverse.axis), (float8)(traversal->shift.axis))
    const float8 near_x = T(traversal->near_x, x, near_shift), far_x = T(3u - traversal->near_x, x, far_shift);
    const float8 near_y = T(traversal->near_y, y, near_shift), far_y = T(5u - traversal->near_y, y, far_shift);
    const float8 near_z = T(traversal->near_z, z, near_shift), far_z = T(7u - traversal->near_z, z, far_shift);
#undef T
    *enter = maximum(maximum(near_x, near_y), maximum(near_z, (float8)(0.0f)));
    return *enter <= minimum(minimum(far_x, far_y), minimum(far_z, (float8)(ray->t_max)));
}

FUNCTION bool is_node(uint word) { return (word & BVH_LEAF) == 0u; }

/// What is loaded first of it is on its way to the processor when the ray's turn comes again. A hint that changes nothing.
FUNCTION void fetch(const Course *course, uint word) {
#if __has_builtin(__builtin_prefetch)
    const uint target = word >> BVH_TARGET_SHIFT;
    const ulong address = course->addresses[target] + (ulong)(word & BVH_BLOCK) * course->sizes[target];
    __builtin_prefetch((const void *)address, 0, 3);
    __builtin_prefetch((const void *)(address + 128u), 0, 3);
#endif
}

FUNCTION bool closest_step(const Course *course, Traversal *traversal) {
    const uint current = traversal->current;
    uint size = traversal->size;
    if (is_node(current)) {
        const global BvhNode *node = course->nodes + current;
        float8 enter;
        const int8 met = children_met(node, traversal, &enter);
        const int8 lane = (int8)(0, 1, 2, 3, 4, 5, 6, 7);
        const int8 order = sorted(met ? (as_int8(enter) & (int8)(~7)) | lane : (int8)(-1));
        vstore8(order, 0, traversal->entered + size);
        vstore8(picked(*(const global uint8 *)node->child, as_uint8(order)), 0, traversal->children + size);
        size += popcount(mask_bits(met));
    } else {
        ray_x8 ray = widened(&traversal->ray);
        WORLD_CLOSEST_HIT(course->scene, course->world, current >> BVH_KIND_SHIFT & 7u, current & BVH_BLOCK, &ray, &traversal->nearest);
        traversal->ray.t_max = ray.t_max.s0;
    }
    const int last = as_int(traversal->ray.t_max);
    do {
        if (size == 0u) return false;
        --size;
    } while ((traversal->entered[size] & ~7) > last);
    traversal->size = size, traversal->current = traversal->children[size];
    fetch(course, traversal->current);
    return true;
}

/// The children with the fewest primitives come first, as in any_hit.
FUNCTION bool any_step(const Course *course, Traversal *traversal) {
    const uint current = traversal->current;
    uint size = traversal->size;
    if (is_node(current)) {
        const global BvhNode *node = course->nodes + current;
        float8 enter;
        const uint bits = mask_bits(children_met(node, traversal, &enter));
        store_picked(*(const global uint8 *)node->child, bits, traversal->children + size);
        size += popcount(bits);
    } else {
        const ray_x8 ray = widened(&traversal->ray);
        if (WORLD_ANY_HIT(course->scene, course->world, current >> BVH_KIND_SHIFT & 7u, current & BVH_BLOCK, &ray, 0)) {
            traversal->nearest.hit.primitive = 0u;
            return false;
        }
    }
    if (size == 0u) return false;
    traversal->size = size - 1u, traversal->current = traversal->children[size - 1u];
    fetch(course, traversal->current);
    return true;
}
