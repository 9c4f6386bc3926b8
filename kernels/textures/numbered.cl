// The scene's pictures by their numbers.
#pragma once
#include "kernels/core/lanes_1.cl"
#include "kernels/core/scene.cl"
#include "kernels/textures/texture.cl"

/// The colour of the picture of that number + 1; 0 is white. The scene has its texels.
FUNCTION Spectrum color_of(Scene scene, uint texture, vec2 uv) {
    return texture == 0u ? make3(1.0f, 1.0f, 1.0f) : texture_color(scene.texels, SCENE_ARRAY(scene, TextureRecord, textures)[texture - 1u], uv);
}
