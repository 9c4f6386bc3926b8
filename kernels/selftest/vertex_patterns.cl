// What a triangle's vertices have, between them, in the precision in force.
#include "generated/precision.cl"
#include "kernels/core/items.cl"
#include "kernels/primitives/triangle.cl"

/// Triangle i where the weights of its second and third vertex are weights[i].
kernel void test_vertex_patterns(SCENE_PARAMS, const global ShadingRecord *restrict records, const global vec2 *restrict weights, uint count,
                                 global Pattern *restrict patterns) {
    const Scene scene = SCENE;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const Ray ray = {{0.0f, 0.0f, 0.0f}, 0.0f, {0.0f, 0.0f, 0.0f}, 0u};  // of no matter
        const Hit hit = {0.0f, weights[i].x, weights[i].y, i};
        patterns[i] = triangle_pattern(scene, records[i], ray, hit);
    }
}
