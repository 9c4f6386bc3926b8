// Visibility along shadow rays that come from scattered places, in scenes without instances: in rows of 16 at the root of the hierarchy, several in
// turn below it. Same answers as trace_shadow_rays.
#include "generated/interleaved_root.cl"
#include "kernels/accelerators/interleaved.cl"
#include "kernels/accelerators/sorted_rays.cl"
#include "kernels/core/tally.cl"

/// Those of a row that go on below the root come to the list.
FUNCTION uint list_row(const uint *numbers, uint count, uint occluded, uint go_on, global uchar *visible, uint *list) {
    uint listed = 0u;
    for (uint j = 0u; j < count; ++j) {
        if (occluded >> j & 1u) visible[numbers[j]] = 0;
        list[listed] = numbers[j], listed += go_on >> j & 1u;
    }
    return listed;
}

/// Rays numbers[0] ... numbers[count - 1], at most ITEMS_PER_CHUNK.
FUNCTION void trace_below(const Course *course, const uint *numbers, uint count, const global Ray *rays, global uchar *visible, Tally *tally) {
    uint next = 0u;
    PreparedRays prepared[ITEMS_PER_CHUNK / ROW];
    prepare_numbers(rays, numbers, count, course->world->extent, prepared);
#define BEGIN(traversal, k) any_go_on(course, traversal, prepared + k / ROW, k % ROW)
#define END(traversal, k)                                               \
    const bool occluded = (traversal)->nearest.hit.primitive != NO_HIT; \
    if (occluded) visible[numbers[k]] = 0;                              \
    tally->hits[RAY_SHADOW] += occluded
    TRACE_IN_TURN(next, count, course, BEGIN, any, END)
#undef BEGIN
#undef END
}

/// As trace_shadow_rays.
kernel void trace_shadow_rays_root_rows(SCENE_PARAMS, const global uint *restrict live, const global uint *restrict counts, uint stride,
                                        const global Ray *restrict rays, const global uint *restrict instances, global uchar *restrict visible,
                                        global Tally *restrict tallies) {
    const Course course = course_of(SCENE);
    const uint line = get_global_id(1), nodes = nodes_of_root(&course);
    Tally tally = {{0ul}, {0ul}};
    SortedRays sorted;
    uint below[RAYS_PER_SORT], count_below = 0u;
    sort_rays(rays, live + line * stride, chunks_of(counts[line], CHUNKS_PER_SORT), &sorted);
    FOR_EACH_SORTED_ROW(&sorted, axis, begin, rays_here) {
        const Row row = sorted_row(rays, &sorted, begin, rays_here);
        TracedRow traced = traced_row(&row, axis, course.world->extent);
        const uint occluded = root_occluded(&course, &traced), go_on = rays_meeting(course.nodes, nodes, &traced.rays);
        count_below += list_row(sorted.numbers + begin, rays_here, occluded, go_on, visible, below + count_below);
        tally.rays[RAY_SHADOW] += rays_here, tally.hits[RAY_SHADOW] += popcount(occluded);
    }
    for (uint k = 0u; k < count_below; k += ITEMS_PER_CHUNK)
        trace_below(&course, below + k, min(count_below - k, ITEMS_PER_CHUNK), rays, visible, &tally);
    add_tally(tallies + get_global_id(0) + get_global_size(0) * line, tally);
}
