// Closest hits of a list of rays that go their own ways, in scenes without instances: in rows of 16 at the root of the hierarchy, several in turn
// below it. Same bits as intersect.
#include "generated/interleaved_root.cl"
#include "kernels/accelerators/interleaved.cl"
#include "kernels/accelerators/row_results.cl"
#include "kernels/accelerators/sorted_rays.cl"
#include "kernels/core/tally.cl"

/// Rays that go on below the root, and where what they met there leaves them.
typedef struct {
    uint places[RAYS_PER_SORT], numbers[RAYS_PER_SORT];  ///< as SortedRays has them
    float next[RAYS_PER_SORT];                           ///< as Nearest has it
    uint count;
} RaysBelow;

FUNCTION void store_row(const SortedRays *sorted, uint begin, uint count, RowHits closest, uint go_on, global Hit *hits, global uchar *crowded,
                        RaysBelow *below) {
    float4 hit[ROW];
    float next[ROW];
    hits_of_row(closest, hit);
    vstore16(closest.next, 0, next);
    const uint crowd = INTERIOR_SIZE > 0u ? crowded_lanes(closest) : 0u;
    for (uint j = 0u; j < count; ++j) {
        const uint i = sorted->places[begin + j], k = below->count;
        vstore4(hit[j], i, (global float *)hits);
        if (INTERIOR_SIZE > 0u) crowded[i] = crowd >> j & 1u;
        below->places[k] = i, below->numbers[k] = sorted->numbers[begin + j], below->next[k] = next[j];
        below->count += go_on >> j & 1u;
    }
}

/// Rays first ... first + ITEMS_PER_CHUNK - 1 of those that go on.
FUNCTION void trace_below(const Course *course, const RaysBelow *below, uint first, const global Ray *rays, global Hit *hits, global uchar *crowded,
                          Tally *tally) {
    uint next = first;
    const uint end = min(first + ITEMS_PER_CHUNK, below->count);
    PreparedRays prepared[ITEMS_PER_CHUNK / ROW];
    prepare_numbers(rays, below->numbers + first, end - first, course->world->extent, prepared);
#define BEGIN(traversal, k) \
    closest_go_on(course, traversal, prepared + (k - first) / ROW, (k - first) % ROW, rays[below->numbers[k]], hits[below->places[k]], below->next[k])
#define END(traversal, k)                                                    \
    const Nearest nearest = (traversal)->nearest;                            \
    hits[below->places[k]] = nearest.hit;                                    \
    if (INTERIOR_SIZE > 0u) crowded[below->places[k]] = is_crowded(nearest); \
    const uint kind = RAY_KIND(rays[below->numbers[k]].tag);                 \
    tally->rays[kind] += 1u;                                                 \
    tally->hits[kind] += nearest.hit.primitive != NO_HIT
    TRACE_IN_TURN(next, end, course, BEGIN, closest, END)
#undef BEGIN
#undef END
}

/// As intersect.
kernel void intersect_root_rows(SCENE_PARAMS, LIVE_PARAMS, const global Ray *restrict rays, const global uint *restrict sources,
                                global Hit *restrict hits, global uint *restrict instances, global uchar *restrict crowded,
                                global Tally *restrict tallies) {
    const Course course = course_of(SCENE);
    const float extent = course.world->extent;
    const uint nodes = nodes_of_root(&course);
    Tally tally = {{0ul}, {0ul}};
    SortedRays sorted;
    RaysBelow below;
    below.count = 0u;
    sort_rays(rays, live + first, chunks_of(count, CHUNKS_PER_SORT), &sorted);
    FOR_EACH_SORTED_ROW(&sorted, axis, begin, rays_here) {
        const Row row = sorted_row(rays, &sorted, begin, rays_here);
        TracedRow traced = traced_row(&row, axis, extent);
        RowHits closest = row_without_hits(&row, extent);
        root_closest_hits(&course, &traced, &closest);
        const uint go_on = rays_meeting(course.nodes, nodes, &traced.rays);
        store_row(&sorted, begin, rays_here, closest, go_on, hits, crowded, &below);
        count_rays(&row, first_lanes(rays_here) & ~go_on, &closest, &tally);
    }
    for (uint k = 0u; k < below.count; k += ITEMS_PER_CHUNK) trace_below(&course, &below, k, rays, hits, crowded, &tally);
    add_tally(tallies + get_global_id(0), tally);
}
