// Colours of pictures between their texels.
#pragma once
#include "kernels/core/lanes_1.cl"
#include "kernels/textures/texture.h"

/// A half float that is finite and not negative.
FUNCTION float float_of_half(uint bits) { return as_float(bits << 13) * 0x1p112f; }

FUNCTION Spectrum texel(const global Texel *texels, TextureRecord texture, uint column, uint row) {
    const global Texel *at = texels + (texture.offset + (ulong)row * texture.width + column);
    return make3(float_of_half(at->red_green & 0xffffu), float_of_half(at->red_green >> 16), float_of_half(at->blue));
}

/// Two neighbours along one axis, and the weight of the second.
typedef struct {
    uint first, second;
    float weight;
} TexelPair;

/// At `x` in picture widths from the first edge. The middle of texel i is at (i + 1/2) / count.
FUNCTION TexelPair texel_pair(float x, uint count, bool clamps) {
    const float inside = clamps ? minimum(maximum(x, 0.0f), 1.0f) : x - floor(x);
    const float place = inside * (float)(int)count - 0.5f, below = floor(place);
    const int last = (int)count - 1, first = (int)below, second = first + 1;
    TexelPair pair;
    pair.first = (uint)(first >= 0 ? min(first, last) : clamps ? 0 : last);
    pair.second = (uint)(second <= last ? second : clamps ? last : 0);
    pair.weight = place - below;
    return pair;
}

FUNCTION Spectrum mixed(Spectrum a, Spectrum b, float weight_of_b) { return plus(scaled(a, 1.0f - weight_of_b), scaled(b, weight_of_b)); }

/// The picture's colour at (u, v): u grows to the right, v upwards, the picture lies in [0, 1]^2. Bilinear.
FUNCTION Spectrum texture_color(const global Texel *texels, TextureRecord texture, vec2 uv) {
    const TexelPair column = texel_pair(uv.x, texture.width, (texture.flags & TEXTURE_CLAMPS_U) != 0u);
    const TexelPair row = texel_pair(1.0f - uv.y, texture.height, (texture.flags & TEXTURE_CLAMPS_V) != 0u);
    const Spectrum above = mixed(texel(texels, texture, column.first, row.first), texel(texels, texture, column.second, row.first), column.weight);
    const Spectrum below = mixed(texel(texels, texture, column.first, row.second), texel(texels, texture, column.second, row.second), column.weight);
    return mixed(above, below, row.weight);
}
