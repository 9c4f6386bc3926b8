#include "scene/textures/textured.h"

#include <filesystem>

#include "scene/error.h"
#include "scene/parameters.h"
#include "scene/scene.h"

namespace brandung {
namespace {

std::string beside_scene(const Scene &scene, const std::string &file) { return (std::filesystem::path(scene.file).parent_path() / file).string(); }

uint read_picture_at(const Parameters &parameters, const char *key, TextureWrap wrap, Scene &scene) {
    // Encoding numbers the choices.
    static_assert(Encoding(0) == Encoding::automatic && Encoding(1) == Encoding::srgb && Encoding(2) == Encoding::linear);
    const Encoding encoding{parameters.choice("encoding", {"auto", "srgb", "linear"}, 0)};
    const std::string file = parameters.text(key);
    parameters.expect_all_known();
    try {
        return read_texture(scene, beside_scene(scene, file), {wrap, encoding});
    } catch (const SceneError &error) {
        parameters.fail(key, error.what());
    }
}

}  // namespace

TexturedSpectrum read_textured(const Parameters &parameters, const std::string &name, Spectrum fallback, Scene &scene) {
    if (!parameters.is_object(name)) return {parameters.spectrum(name, fallback), 0};
    const Parameters texture = parameters.child(name);
    static_assert(TextureWrap(0) == TextureWrap::repeat && TextureWrap(1) == TextureWrap::clamp);
    const TextureWrap wrap{texture.choice("wrap", {"repeat", "clamp"}, 0)};
    const Spectrum scale = texture.spectrum("scale", Spectrum(1));
    return {scale, read_picture_at(texture, "texture", wrap, scene)};
}

TexturedSpectrum read_textured_fraction(const Parameters &parameters, const std::string &name, Spectrum fallback, Scene &scene) {
    if (!parameters.is_object(name)) return {parameters.fraction(name, fallback), 0};
    return read_textured(parameters, name, fallback, scene);
}

void read_background(const Parameters &root, Scene &scene) {
    if (!root.has("background")) return;
    scene.background_texture = 0;
    if (!root.is_object("background")) {
        scene.background = root.spectrum("background");
        return;
    }
    const Parameters background = root.child("background");
    scene.background = background.spectrum("scale", Spectrum(1));
    scene.background_turn = background.number("rotate", 0.0f) / 360;
    scene.background_texture = read_picture_at(background, "image", TextureWrap::panorama, scene);
}

}  // namespace brandung
