// Visibility along shadow rays in rows of 16, each against every primitive: in scenes that have few, and no instances. Same answers as
// trace_shadow_rays.
#include "kernels/accelerators/rows.cl"
#include "kernels/accelerators/sorted_rays.cl"
#include "kernels/core/tally.cl"

/// As trace_shadow_rays.
kernel void trace_shadow_rays_rows(SCENE_PARAMS, const global uint *restrict live, const global uint *restrict counts, uint stride,
                                   const global Ray *restrict rays, const global uint *restrict instances, global uchar *restrict visible,
                                   global Tally *restrict tallies) {
    const Scene scene = SCENE;
    const uint line = get_global_id(1);
    Tally tally = {{0ul}, {0ul}};
    SortedRays sorted;
    sort_rays(rays, live + line * stride, chunks_of(counts[line], CHUNKS_PER_SORT), &sorted);
    FOR_EACH_SORTED_ROW(&sorted, axis, begin, rays_here) {
        const Row row = sorted_row(rays, &sorted, begin, rays_here);
        TracedRow traced = traced_row(&row, axis, scene.header->world.extent);
        tally.rays[RAY_SHADOW] += rays_here;
        for (uint bits = row_occluded(scene, &traced); bits != 0u; bits &= bits - 1u) {
            visible[sorted.numbers[begin + lowest_bit(bits)]] = 0;
            tally.hits[RAY_SHADOW] += 1u;
        }
    }
    add_tally(tallies + get_global_id(0) + get_global_size(0) * line, tally);
}
