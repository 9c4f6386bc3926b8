// Visibility along shadow rays, several rays in turn: for rays that come from scattered places. Same answers as trace_shadow_rays.
#include "generated/instances.cl"
#include "kernels/accelerators/interleaved.cl"
#include "kernels/core/tally.cl"

/// As trace_shadow_rays.
kernel void trace_shadow_rays_interleaved(SCENE_PARAMS, const global uint *restrict live, const global uint *restrict counts, uint stride,
                                          const global Ray *restrict rays, const global uint *restrict instances, global uchar *restrict visible,
                                          global Tally *restrict tallies) {
    const Course course = course_of(SCENE);
    const uint row = get_global_id(1);
    const global uint *list = live + row * stride;
    Tally tally = {{0ul}, {0ul}};
    uint next = get_global_id(0) * ITEMS_PER_WORK_ITEM;
    const uint end = min(next + ITEMS_PER_WORK_ITEM, counts[row]);
    PreparedRays prepared[ITEMS_PER_CHUNK / ROW];
    prepare_list(rays, list, next, end, instances, row * stride, course.world->extent, prepared);
    const uint start = next;
#define BEGIN(traversal, i) any_begin(&course, traversal, prepared + (i - start) / ROW, (i - start) % ROW)
#define END(traversal, i)                                               \
    const bool occluded = (traversal)->nearest.hit.primitive != NO_HIT; \
    if (occluded) visible[list[i]] = 0;                                 \
    tally.rays[RAY_SHADOW] += 1u;                                       \
    tally.hits[RAY_SHADOW] += occluded
    TRACE_IN_TURN(next, end, &course, BEGIN, any, END)
#undef BEGIN
#undef END
    add_tally(tallies + get_global_id(0) + get_global_size(0) * row, tally);
}
