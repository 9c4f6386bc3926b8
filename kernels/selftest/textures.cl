// Colours of pictures, one after another, in the precision in force.
#include "generated/precision.cl"
#include "kernels/core/items.cl"
#include "kernels/textures/texture.cl"

/// Picture i at place i.
kernel void test_textures(const global Texel *restrict texels, const global TextureRecord *restrict textures, const global vec2 *restrict places,
                          uint count, global Spectrum *restrict colors) {
    FOR_EACH_ITEM_SERIALLY(i, count) { colors[i] = texture_color(texels, textures[i], places[i]); }
}
