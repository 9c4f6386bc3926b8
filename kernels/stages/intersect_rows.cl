// Closest hits of a list of rays in rows of 16, each against every primitive: in scenes that have few, and no instances. Same bits as intersect.
#include "kernels/accelerators/row_results.cl"
#include "kernels/accelerators/rows.cl"
#include "kernels/accelerators/sorted_rays.cl"
#include "kernels/core/tally.cl"

/// As intersect.
kernel void intersect_rows(SCENE_PARAMS, LIVE_PARAMS, const global Ray *restrict rays, const global uint *restrict sources, global Hit *restrict hits,
                           global uint *restrict instances, global uchar *restrict crowded, global Tally *restrict tallies) {
    const Scene scene = SCENE;
    const float extent = scene.header->world.extent;
    Tally tally = {{0ul}, {0ul}};
    SortedRays sorted;
    sort_rays(rays, live + first, chunks_of(count, CHUNKS_PER_SORT), &sorted);
    FOR_EACH_SORTED_ROW(&sorted, axis, begin, rays_here) {
        const Row row = sorted_row(rays, &sorted, begin, rays_here);
        TracedRow traced = traced_row(&row, axis, extent);
        RowHits closest = row_without_hits(&row, extent);
        row_closest_hits(scene, &traced, &closest);
        float4 hit[ROW];
        hits_of_row(closest, hit);
        const uint crowd = INTERIOR_SIZE > 0u ? crowded_lanes(closest) : 0u;
        for (uint j = 0u; j < rays_here; ++j) {
            const uint i = sorted.places[begin + j];
            vstore4(hit[j], i, (global float *)hits);
            if (INTERIOR_SIZE > 0u) crowded[i] = crowd >> j & 1u;
        }
        count_rays(&row, first_lanes(rays_here), &closest, &tally);
    }
    add_tally(tallies + get_global_id(0), tally);
}
