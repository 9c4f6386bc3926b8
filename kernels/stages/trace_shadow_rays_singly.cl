// Visibility along shadow rays, one ray after another: for rays that come from scattered places. Same answers as trace_shadow_rays.
#include "generated/instances.cl"
#include "kernels/accelerators/levels.cl"
#include "kernels/core/tally.cl"

/// As trace_shadow_rays.
kernel void trace_shadow_rays_singly(SCENE_PARAMS, const global uint *restrict live, const global uint *restrict counts, uint stride,
                                     const global Ray *restrict rays, const global uint *restrict instances, global uchar *restrict visible,
                                     global Tally *restrict tallies) {
    const Scene scene = SCENE;
    const uint row = get_global_id(1);
    const global uint *list = live + row * stride;
    Tally tally = {{0ul}, {0ul}};
    FOR_EACH_ITEM_SERIALLY(i, counts[row]) {
        const uint k = list[i];
        const bool occluded = scene_any_hit(scene, rays[k], instance_at(instances, k - row * stride), 0);
        if (occluded) visible[k] = 0;
        tally.rays[RAY_SHADOW] += 1u;
        tally.hits[RAY_SHADOW] += occluded;
    }
    add_tally(tallies + get_global_id(0) + get_global_size(0) * row, tally);
}
