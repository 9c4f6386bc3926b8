/// Pictures that colour surfaces.
#pragma once
#include <string>
#include <vector>

#include "kernels/textures/texture.h"
#include "scene/image.h"

namespace brandung {

struct Scene;

/// What lies beyond a picture's edges.
enum class TextureWrap : uint {
    repeat,    ///< the picture again
    clamp,     ///< its edge
    panorama,  ///< the picture again to the left and right, its edge above and below
};

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

/// Rounded to half floats.
Texel texel_of(vec3 color);

/// Pictures as kernels read them.
struct TexturePixels {
    std::vector<TextureRecord> records;  ///< as Scene::textures
    std::vector<Texel> texels;
};
/// Of the pictures in use; the others' records are empty. Throws SceneError if they have too many texels.
TexturePixels pixels_of(const std::vector<Texture> &textures, const std::vector<bool> &used);

}  // namespace brandung
