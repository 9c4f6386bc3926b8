// What arrives of the light along shadow rays through transparent things. Only on request, in scenes that have some.
#include "kernels/stages/transmission.cl"

/// Work-items (chunk, row), after trace_shadow_rays and with its lists. filters[k] is what arrives of the light along ray k: all of it where
/// visible[k] is set, for nothing was met; elsewhere visible[k] becomes 1 if anything arrives.
kernel void filter_shadow_rays(SCENE_PARAMS, const global uint *restrict live, const global uint *restrict counts, uint stride,
                               const global Ray *restrict rays, const global uint *restrict instances, global uchar *restrict visible,
                               global Spectrum *restrict filters) {
    const Scene scene = SCENE;
    const uint row = get_global_id(1);
    const global uint *list = live + row * stride;
    FOR_EACH_ITEM_SERIALLY(i, counts[row]) {
        const uint k = list[i];
        const Spectrum light =
            visible[k] != 0 ? make3(1.0f, 1.0f, 1.0f) : transmission_along(scene, rays[k], instance_at(instances, k - row * stride), 0);
        filters[k] = light;
        visible[k] = largest(light) > 0.0f;
    }
}
