// Crossings and surfaces of one kind of primitive: primitive i against ray i.
#include "kernels/selftest/one_lane.cl"

typedef struct {
    float t, u, v;
    Surface surface;
    vec2 uv;  ///< of kinds with vertices the crossing's, by which what these have is interpolated; of others those of pictures
    uint hit;
} CrossingResult;

kernel void test_crossings(SCENE_PARAMS, const global Block *restrict blocks, const global ShadingRecord *restrict records,
                           const global float *restrict extents, const global Ray *restrict rays, uint count,
                           global CrossingResult *restrict results) {
    const Scene scene = SCENE;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const Ray ray = rays[i];
        const Crossing crossing = cross_one(blocks, i, ray, extents[i]);
        CrossingResult result;
        result.t = crossing.t, result.u = crossing.u, result.v = crossing.v, result.hit = crossing.hit != 0;
        if (result.hit) {
            const Hit hit = hit_of(crossing, i);
            result.surface = NAME(surface)(scene, records[i], ray, hit);
            result.uv = NAME(pattern)(scene, records[i], ray, hit).uv;
            if (HAS_VERTICES) result.uv.x = hit.u, result.uv.y = hit.v;
        }
        results[i] = result;
    }
}
