/// Pictures as textures: read once, cut to what surfaces and film can hold, left out where they cannot be read.
#include "scene/textures/texture.h"

#include <gtest/gtest.h>

#include <limits>

#include "scene/error.h"
#include "scene/scene.h"
#include "tests/scene/formats/temporary_file.h"

namespace brandung {
namespace {

std::string picture_file(const TemporaryFile &file, const std::vector<vec3> &pixels) {
    write_picture(file.path, {static_cast<uint>(pixels.size()), 1, pixels, {}});
    return file.path;
}

TEST(Texture, ReadsAFileOnceForTheSameOptions) {
    const TemporaryFile file("x", ".exr");
    const std::string path = picture_file(file, {vec3(0.25f)});
    Scene scene;
    EXPECT_EQ(read_texture(scene, path), 1u);
    EXPECT_EQ(read_texture(scene, path), 1u);
    EXPECT_EQ(read_texture(scene, path, {.wrap = TextureWrap::clamp}), 2u);
    EXPECT_EQ(read_texture(scene, path), 1u);
    EXPECT_EQ(scene.textures.size(), 2u);
}

TEST(Texture, EncodingDecidesWhatNumbersMean) {
    const TemporaryFile file("x", ".png");
    const std::string path = picture_file(file, {vec3(0.5f)});  // 188 of 255 by the sRGB curve: back, ((188 / 255 + 0.055) / 1.055)^2.4
    Scene scene;
    read_texture(scene, path);
    read_texture(scene, path, {.encoding = Encoding::linear});
    EXPECT_NEAR(scene.textures[0].picture.pixels[0].x, 0.502886f, 1e-6f);
    EXPECT_FLOAT_EQ(scene.textures[1].picture.pixels[0].x, 188 / 255.0f);
}

TEST(Texture, CutsWhatNoSurfaceReflectsAndCountsIt) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const TemporaryFile file("x", ".exr");
    const std::string path = picture_file(file, {{-1, 2, 3}, {infinity, 1, std::nanf("")}, {1e6f, 0, 0}, {1, 1, 1}});
    Scene scene;
    read_texture(scene, path);
    const std::vector<vec3> expected = {{0, 2, 3}, {0, 1, 0}, {largest_texel, 0, 0}, {1, 1, 1}};
    EXPECT_EQ(scene.textures[0].picture.pixels, expected);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings.begin()->second, 3u);
}

TEST(Texture, AFileThatIsNoPictureIsLeftOutWithAWarningOrRefused) {
    const TemporaryFile file("this is no picture", ".png");
    Scene scene;
    EXPECT_EQ(add_texture(scene, file.path), 0u);
    EXPECT_EQ(add_texture(scene, file.path), 0u);
    EXPECT_EQ(add_texture(scene, "there_is_none.png"), 0u);
    EXPECT_TRUE(scene.textures.empty());
    ASSERT_EQ(scene.warnings.size(), 2u);
    for (const auto &[text, count] : scene.warnings) {
        EXPECT_TRUE(text.starts_with("texture left out: ")) << text;
        EXPECT_EQ(count, text.find("there_is_none") == std::string::npos ? 2u : 1u);
    }
    EXPECT_THROW(read_texture(scene, file.path), SceneError);
}

}  // namespace
}  // namespace brandung
