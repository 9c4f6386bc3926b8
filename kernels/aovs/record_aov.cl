// Template: records a value of each camera ray's hit. The includer has defined aov_value(scene, ray, hit, point, tint).
#include "generated/tints.cl"
#include "kernels/core/load.cl"

/// values[first + i] is that of camera ray live[first + i]; infinity in x where there is none.
kernel void record_aov(SCENE_PARAMS, LIVE_PARAMS, const global Ray *restrict rays, const global Hit *restrict hits,
                       const global SurfacePoint *restrict points, const global Tints *restrict tints, global vec3 *restrict values) {
    const Scene scene = SCENE;
    const global uint *list = live + first;
    global vec3 *results = values + first;
    FOR_EACH_ITEM(i, count) {
        const Ray ray = load(rays + list[i]);
        const Hit hit = load(hits + i);
        const SurfacePoint point = load(points + i);
        results[i] = aov_value(scene, ray, hit, point, tints_at(tints, i));
    }
}
