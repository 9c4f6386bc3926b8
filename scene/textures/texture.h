/// Pictures that colour surfaces.
#pragma once
#include <string>

#include "scene/image.h"

namespace brandung {

struct Scene;

/// What lies beyond a picture's edges: the picture again, or its edge.
enum class TextureWrap : uint { repeat, clamp };

struct TextureOptions {
    TextureWrap wrap = TextureWrap::repeat;
    Encoding encoding = Encoding::automatic;
    bool operator==(const TextureOptions &) const = default;
};

/// A picture as materials refer to it. Its left lower corner has the texture coordinates (0, 0), its right upper one (1, 1).
struct Texture {
    std::string file;
    TextureOptions options;
    Picture picture;  ///< linear, no part negative or beyond largest_texel
};

inline constexpr float largest_texel = 65504;  ///< of a half float

/// 1 + the place in Scene::textures of the picture, which is read unless it is there already. Throws SceneError if it cannot be read.
uint read_texture(Scene &scene, const std::string &file, const TextureOptions &options = {});
/// The same, but 0, which stands for no texture, with a counted warning if the picture cannot be read.
uint add_texture(Scene &scene, const std::string &file, const TextureOptions &options = {});

}  // namespace brandung
