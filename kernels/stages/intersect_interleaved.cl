// Closest hits of a list of rays, several rays in turn: for rays that go their own ways. Same bits as intersect.
#include "generated/instances.cl"
#include "kernels/accelerators/interleaved.cl"
#include "kernels/core/tally.cl"

/// As intersect.
kernel void intersect_interleaved(SCENE_PARAMS, LIVE_PARAMS, const global Ray *restrict rays, const global uint *restrict sources,
                                  global Hit *restrict hits, global uint *restrict instances, global uchar *restrict crowded,
                                  global Tally *restrict tallies) {
    const Course course = course_of(SCENE);
    Tally tally = {{0ul}, {0ul}};
    uint next = get_global_id(0) * ITEMS_PER_WORK_ITEM;
    const uint end = min(next + ITEMS_PER_WORK_ITEM, count);
    PreparedRays prepared[ITEMS_PER_CHUNK / ROW];
    prepare_list(rays, live + first, next, end, sources, 0u, course.world->extent, prepared);
    const uint start = next;
#define BEGIN(traversal, i) closest_begin(&course, traversal, prepared + (i - start) / ROW, (i - start) % ROW, rays[live[first + i]])
#define END(traversal, i)                                        \
    const Nearest nearest = (traversal)->nearest;                \
    hits[i] = nearest.hit;                                       \
    store_instance(instances, i, place_of(closest_of(nearest))); \
    if (INTERIOR_SIZE > 0u) crowded[i] = is_crowded(nearest);    \
    const uint kind = RAY_KIND(rays[live[first + i]].tag);       \
    tally.rays[kind] += 1u;                                      \
    tally.hits[kind] += nearest.hit.primitive != NO_HIT
    TRACE_IN_TURN(next, end, &course, BEGIN, closest, END)
#undef BEGIN
#undef END
    add_tally(tallies + get_global_id(0), tally);
}
