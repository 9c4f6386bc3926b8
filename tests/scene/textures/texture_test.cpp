/// Pictures as textures: read once, cut to what surfaces and film can hold, left out where they cannot be read.
#include "scene/textures/texture.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>
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

/// As fast as one picture with as many texels. Growing by one picture at a time would copy what has been before for each: 500 times as much.
TEST(Texture, ManyPicturesTakeTheTimeOfTheirTexels) {
    const auto textures_of = [](std::size_t count, uint side) {
        std::vector<Texture> textures(count);
        for (Texture &texture : textures) texture.picture = {side, side, std::vector<vec3>(side * side, vec3(0.5f)), {}};
        return textures;
    };
    const auto processor_time = [](const std::vector<Texture> &textures) {
        const std::clock_t begin = std::clock();
        const TexturePixels pixels = pixels_of(textures, std::vector<bool>(textures.size(), true));
        EXPECT_EQ(pixels.texels.size(), 1u << 22);
        return double(std::clock() - begin);
    };
    const std::vector<Texture> one = textures_of(1, 2048), many = textures_of(1024, 64);
    processor_time(one);
    EXPECT_LT(processor_time(many), 8 * processor_time(one));
}

/// A PNG of 8 bits with so many channels.
std::string png_file(const TemporaryFile &file, int width, int height, int channels, const std::vector<std::uint8_t> &bytes) {
    OIIO::ImageSpec spec(width, height, channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const auto output = OIIO::ImageOutput::create(file.path);
    EXPECT_TRUE(output && output->open(file.path, spec) && output->write_image(OIIO::TypeDesc::UINT8, bytes.data()) && output->close());
    return file.path;
}

std::vector<vec3> pixels_read(const std::string &file) {
    Scene scene;
    read_texture(scene, file);
    return scene.textures[0].picture.pixels;
}

TEST(Texture, GreyIsThreeEqualPartsAndAlphaIsLeftOut) {
    const TemporaryFile file("", ".png");
    const std::vector<vec3> white_black = {Spectrum(1), Spectrum(0)}, red_green = {{1, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(pixels_read(png_file(file, 2, 1, 1, {255, 0})), white_black);
    EXPECT_EQ(pixels_read(png_file(file, 2, 1, 2, {255, 128, 0, 128})), white_black);
    EXPECT_EQ(pixels_read(png_file(file, 2, 1, 4, {255, 0, 0, 0, 0, 255, 0, 128})), red_green);
}

std::string why_not(const std::string &file) try {
    Scene scene;
    read_texture(scene, file);
    return "";
} catch (const SceneError &error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return std::string(error.what()).substr(file.size());
}

TEST(Texture, SaysInOneLineWhyAFileIsNoPicture) {
    const TemporaryFile empty("", ".png"), damaged("\x89PNG\r\n\x1a\n....", ".jpg"), invented("x", ".null");
    EXPECT_EQ(why_not(empty.path), ": is empty");
    for (const std::string &path : {damaged.path, invented.path}) EXPECT_TRUE(why_not(path).starts_with(": cannot read the picture")) << path;
    const std::string png = png_file(empty, 64, 64, 3, std::vector<std::uint8_t>(64 * 64 * 3, 77));
    std::filesystem::resize_file(png, std::filesystem::file_size(png) / 2);
    EXPECT_NE(why_not(png), "");
}

TEST(Texture, HugePicturesAreRefusedBeforeTheyAreRead) {
    const TemporaryFile file("P6 20000 20000 255\n", ".ppm");
    EXPECT_EQ(why_not(file.path), ": cannot read the picture: 20000 x 20000 pixels are more than 268435456");  // 4e8 > 2^28
}

}  // namespace
}  // namespace brandung
