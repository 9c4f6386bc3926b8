// Colours of pictures, and what a triangle's vertices have between them, one after another, in the precision in force.
#include "generated/precision.cl"
#include "kernels/core/items.cl"
#include "kernels/primitives/triangle.cl"
#include "kernels/textures/texture.cl"

/// Picture i at place i.
kernel void test_textures(const global ushort *restrict texels, const global TextureRecord *restrict textures, const global vec2 *restrict places,
                          uint count, global Spectrum *restrict colors) {
    FOR_EACH_ITEM_SERIALLY(i, count) { colors[i] = texture_color(texels, textures[i], places[i]); }
}

/// Triangle i where the weights of its second and third vertex are weights[i].
kernel void test_vertex_patterns(SCENE_PARAMS, const global ShadingRecord *restrict records, const global vec2 *restrict weights, uint count,
                                 global Pattern *restrict patterns) {
    const Scene scene = SCENE;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        Ray ray;
        Hit hit;
        hit.u = weights[i].x, hit.v = weights[i].y;
        patterns[i] = triangle_pattern(scene, records + i, ray, hit);
    }
}
