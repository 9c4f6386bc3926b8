#include "scene/textures/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/gtc/packing.hpp>
#include <limits>

#include "scene/error.h"
#include "scene/scene.h"

namespace brandung {
namespace {

/// What no surface can reflect and no film hold: negative parts, NaN and infinity become 0, what is too bright the brightest. Gives how many texels
/// had it.
uint repair_texels(Picture &picture) {
    uint repaired = 0;
    for (vec3 &texel : picture.pixels) {
        const vec3 before = texel;
        for (int c = 0; c < 3; ++c) texel[c] = std::isfinite(texel[c]) ? std::clamp(texel[c], 0.0f, largest_texel) : 0.0f;
        repaired += texel != before;
    }
    return repaired;
}

uint flags_of(TextureWrap wrap) {
    return wrap == TextureWrap::clamp ? TEXTURE_CLAMPS_U | TEXTURE_CLAMPS_V : wrap == TextureWrap::panorama ? TEXTURE_CLAMPS_V : 0;
}

}  // namespace

uint read_texture(Scene &scene, const std::string &file, const TextureOptions &options) {
    const auto same = [&](const Texture &texture) { return texture.file == file && texture.options == options; };
    const auto known = std::find_if(scene.textures.begin(), scene.textures.end(), same);
    if (known != scene.textures.end()) return static_cast<uint>(known - scene.textures.begin()) + 1;
    std::error_code error;
    if (std::filesystem::exists(file, error)) scene.files.push_back(file);  // though it may turn out to be no picture
    Texture &texture = scene.textures.emplace_back(Texture{file, options, read_picture(file, options.encoding)});
    if (const uint repaired = repair_texels(texture.picture))
        scene.warnings[fmt::format("texture {}: texels that are negative, not finite or above {:g}: cut", file, largest_texel)] += repaired;
    return static_cast<uint>(scene.textures.size());
}

uint add_texture(Scene &scene, const std::string &file, const TextureOptions &options) {
    try {
        return read_texture(scene, file, options);
    } catch (const SceneError &error) {
        ++scene.warnings[fmt::format("texture left out: {}", error.what())];
        return 0;
    }
}

Texel texel_of(vec3 color) { return {glm::packHalf2x16(vec2(color.x, color.y)), glm::packHalf1x16(color.z)}; }

TexturePixels pixels_of(const std::vector<Texture> &textures, const std::vector<bool> &used) {
    TexturePixels result;
    std::size_t count = 0;
    for (std::size_t i = 0; i < textures.size(); ++i) {
        TextureRecord &record = result.records.emplace_back();
        if (!used[i]) continue;
        const Picture &picture = textures[i].picture;
        record = {static_cast<uint>(count), picture.width, picture.height, flags_of(textures[i].options.wrap)};
        count += picture.pixels.size();
        if (count > std::numeric_limits<uint>::max())
            throw SceneError(fmt::format("{}: with it textures have {} texels, too many", textures[i].file, count));
    }
    result.texels.reserve(count);
    for (std::size_t i = 0; i < textures.size(); ++i) {
        if (!used[i]) continue;
        for (const vec3 &texel : textures[i].picture.pixels) result.texels.push_back(texel_of(texel));
    }
    return result;
}

}  // namespace brandung
