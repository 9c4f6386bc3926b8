#include "scene/image.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "scene/error.h"
#include "scene/tone.h"

namespace brandung {
namespace {

namespace fs = std::filesystem;

/// Removed with all that is in it.
class Folder {
public:
    Folder() : path_(fs::temp_directory_path() / ("brandung-image-" + std::to_string(getpid()))) { fs::create_directory(path_); }
    ~Folder() { fs::remove_all(path_); }
    std::string file(const std::string &name) const { return (path_ / name).string(); }
    bool empty() const { return fs::is_empty(path_); }

private:
    fs::path path_;
};

/// Values from 0 to above 1, in a size that no format must round.
Picture ramp() {
    Picture picture{64, 48, {}, {}};
    for (uint i = 0; i < 64 * 48; ++i) picture.pixels.push_back(vec3(0.001f * float(i), 0.25f, 0.0005f * float(i)));
    return picture;
}

struct Read {
    bool floats;
    std::vector<float> values;
};

Read read(const std::string &file) {
    const auto input = OIIO::ImageInput::open(file);
    if (!input) throw std::runtime_error(OIIO::geterror());
    Read picture{input->spec().format.is_floating_point(), std::vector<float>(3 * 64 * 48)};
    EXPECT_EQ(input->spec().width, 64);
    EXPECT_EQ(input->spec().height, 48);
    EXPECT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, picture.values.data())) << input->geterror();
    return picture;
}

/// IEC 61966-2-1, of 8 bits.
float shown(float linear, float exposure) {
    const double clamped = std::min(std::max(linear * std::exp2(double(exposure)), 0.0), 1.0);
    return float(clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * std::pow(clamped, 1 / 2.4) - 0.055);
}

/// A format by its extension, and how far from exact what it stores may be.
struct Format {
    std::string extension;
    bool floats;
    double tolerance;
};
void PrintTo(const Format &format, std::ostream *out) { *out << format.extension; }

class PictureOf : public testing::TestWithParam<Format> {};

TEST_P(PictureOf, StoresFloatsAsTheyAreOr8BitsThroughExposureAndCurve) {
    const Folder folder;
    const std::string file = folder.file("out." + GetParam().extension);
    check_picture_writable(file, 64, 48);
    EXPECT_TRUE(folder.empty()) << "the check leaves nothing";
    const Picture picture = ramp();
    write_picture(file, picture, {.exposure = 1.5f});
    const Read stored = read(file);
    EXPECT_EQ(stored.floats, GetParam().floats);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const float value = picture.pixels[i][c], expected = stored.floats ? value : shown(value, 1.5f);
            ASSERT_NEAR(stored.values[3 * i + std::size_t(c)], expected, GetParam().tolerance) << "pixel " << i << ", channel " << c;
        }
}

// 8 bits: half a step, and what the curve in float is off. RGBE shares the exponent of the largest channel, here up to 4.
INSTANTIATE_TEST_SUITE_P(Image, PictureOf,
                         testing::Values(Format{"exr", true, 0}, Format{"EXR", true, 0}, Format{"tif", true, 0}, Format{"tiff", true, 0},
                                         Format{"hdr", true, 0.016}, Format{"png", false, 0.0021}, Format{"ppm", false, 0.0021},
                                         Format{"pgm", false, 0.0021}, Format{"bmp", false, 0.0021}, Format{"tga", false, 0.0021},
                                         Format{"jpg", false, 0.2}, Format{"jpeg", false, 0.2}),
                         [](const auto &info) { return info.param.extension; });

TEST(Image, TheGreatestExposuresGiveWhiteAndBlack) {
    const Folder folder;
    Picture picture = ramp();
    picture.pixels.assign(picture.pixels.size(), vec3(0, 1e-6f, 65536));
    for (const float exposure : {-100.0f, 100.0f}) {
        write_picture(folder.file("out.png"), picture, {.exposure = exposure});
        const Read stored = read(folder.file("out.png"));
        EXPECT_EQ(stored.values[0], 0.0f);
        EXPECT_EQ(stored.values[1], exposure > 0 ? 1.0f : 0.0f);
        EXPECT_EQ(stored.values[2], exposure > 0 ? 1.0f : 0.0f);
    }
}

/// The one line that the check gives.
std::string refusal(const std::string &file, uint width, uint height) {
    try {
        check_picture_writable(file, width, height);
    } catch (const SceneError &error) {
        return error.what();
    }
    return "";
}

TEST(Image, FormatsThatCannotTakeThePictureAreRefusedBeforeItIsThere) {
    const Folder folder;
    for (const char *name : {"out.zfile", "out.null", "out.term", "out.xyz", "out"})
        EXPECT_TRUE(refusal(folder.file(name), 64, 48).starts_with(folder.file(name) + ": cannot write")) << name;
    EXPECT_TRUE(refusal(folder.file("out.ico"), 300, 300).starts_with(folder.file("out.ico") + ": cannot write")) << "icons have 256 pixels";
    EXPECT_EQ(refusal(folder.file("out.ico"), 256, 256), "");
    EXPECT_TRUE(folder.empty());
}

TEST(Image, ExrAndPngStoreMetadata) {
    EXPECT_TRUE(stores_metadata("a.exr"));
    EXPECT_TRUE(stores_metadata("a.png"));
    EXPECT_FALSE(stores_metadata("a.jpg"));
    const Folder folder;
    Picture picture = ramp();
    picture.metadata["brandung:answer"] = "42";
    for (const char *name : {"a.exr", "a.png"}) {
        write_picture(folder.file(name), picture);
        EXPECT_EQ(OIIO::ImageInput::open(folder.file(name))->spec().get_string_attribute("brandung:answer"), "42") << name;
    }
}

/// Between two codes of 8 bits lie at most 1/255 of the curve, whose slope towards linear values is at most 2.4 * 1.055^-1 = 2.275: half of it.
/// RGBE has 8 bits of the largest channel, here below 2, and cuts the rest.
TEST(Image, IsReadAsItWasWritten) {
    const Folder folder;
    Picture picture = ramp();
    for (vec3 &pixel : picture.pixels) pixel = glm::min(pixel, vec3(1));
    picture.metadata["brandung:answer"] = "42";
    for (const auto &[name, tolerance] : {std::pair{"a.exr", 0.0f}, {"a.tif", 0.0f}, {"a.hdr", 0x1p-7f}, {"a.png", 0.0045f}}) {
        write_picture(folder.file(name), picture);
        const Picture read = read_picture(folder.file(name));
        ASSERT_EQ(read.width, 64u);
        ASSERT_EQ(read.height, 48u);
        for (std::size_t i = 0; i < read.pixels.size(); ++i)
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(read.pixels[i][c], picture.pixels[i][c], tolerance) << name << ", pixel " << i;
        EXPECT_EQ(read.metadata.contains("brandung:answer"), stores_metadata(name)) << name;
        EXPECT_EQ(read.encoded, name == std::string("a.png")) << name;
    }
}

/// Writes one pixel.
void write_values(const std::string &file, OIIO::TypeDesc type, const std::vector<std::string> &names, const std::vector<float> &values) {
    OIIO::ImageSpec spec(1, 1, int(names.size()), type);
    spec.channelnames = names;
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const auto output = OIIO::ImageOutput::create(file);
    ASSERT_TRUE(output && output->open(file, spec) && output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close()) << file;
}

TEST(Image, ColourIsFoundAmongOtherChannels) {
    const Folder folder;
    const auto read = [&](const std::string &name, OIIO::TypeDesc type, const std::vector<std::string> &names, const std::vector<float> &values) {
        write_values(folder.file(name), type, names, values);
        return read_picture(folder.file(name)).pixels.at(0);
    };
    EXPECT_EQ(read("a.exr", OIIO::TypeDesc::FLOAT, {"A.X", "B", "G", "R", "Z"}, {9, 3, 2, 1, 8}), vec3(1, 2, 3));
    EXPECT_EQ(read("b.exr", OIIO::TypeDesc::FLOAT, {"Y"}, {7}), vec3(7));
    EXPECT_EQ(read("c.png", OIIO::TypeDesc::UINT8, {"Y", "A"}, {1, 0.2f}), vec3(1));
    // A transparent pixel keeps its colour; 16 bits hold 0.5 within 2^-17, which is 0.21404 of the brightest.
    const vec3 clear = read("d.png", OIIO::TypeDesc::UINT16, {"R", "G", "B", "A"}, {0.5f, 1, 0, 0.25f});
    EXPECT_NEAR(clear.x, 0.21404f, 2e-5f);
    EXPECT_EQ(clear.y, 1);
    EXPECT_EQ(clear.z, 0);
}

TEST(Image, WhatCannotBeReadIsRefusedInOneLine) {
    const Folder folder;
    for (const char *name : {"text.png", "unknown.xyz"}) std::ofstream(folder.file(name)) << "no picture";
    std::ofstream(folder.file("empty.exr"));
    write_picture(folder.file("whole.exr"), ramp());
    fs::copy_file(folder.file("whole.exr"), folder.file("cut.exr"));
    fs::resize_file(folder.file("cut.exr"), fs::file_size(folder.file("cut.exr")) / 2);
    fs::create_directory(folder.file("folder.png"));
    for (const char *name : {"text.png", "empty.exr", "cut.exr", "folder.png", "missing.png", "unknown.xyz"}) try {
            read_picture(folder.file(name));
            ADD_FAILURE() << name << " is not refused";
        } catch (const SceneError &error) {
            const std::string what = error.what();
            EXPECT_TRUE(what.starts_with(folder.file(name) + ": ")) << what;
            EXPECT_EQ(what.find('\n'), std::string::npos) << what;
        }
}

struct Stored {
    std::string file;
    std::vector<Bits> bits;
    OIIO::TypeDesc type;
};

TEST(Image, EachFormatTakesTheFirstBitsThatItHas) {
    const Folder folder;
    for (const Stored &stored : {Stored{"a.png", {Bits::sixteen}, OIIO::TypeDesc::UINT16},
                                 {"b.png", {Bits::half, Bits::eight}, OIIO::TypeDesc::UINT8},
                                 {"a.exr", {Bits::sixteen, Bits::half}, OIIO::TypeDesc::HALF},
                                 {"b.exr", {Bits::sixteen}, OIIO::TypeDesc::FLOAT},
                                 {"a.tif", {Bits::sixteen}, OIIO::TypeDesc::UINT16},
                                 {"b.tif", {Bits::eight}, OIIO::TypeDesc::UINT8},
                                 {"a.ppm", {Bits::sixteen}, OIIO::TypeDesc::UINT8},
                                 {"a.hdr", {Bits::eight}, OIIO::TypeDesc::FLOAT},
                                 {"a.jpg", {Bits::single}, OIIO::TypeDesc::UINT8}}) {
        const std::string file = folder.file(stored.file);
        const PictureStyle style{.exposure = -1, .bits = stored.bits};
        check_picture_writable(file, 64, 48, style);
        write_picture(file, ramp(), style);
        const auto input = OIIO::ImageInput::open(file);
        ASSERT_TRUE(input) << file;
        EXPECT_EQ(input->spec().format, stored.type) << file;
    }
    // 16 bits: half a step of the curve, and what the curve in float is off.
    const Picture picture = ramp();
    for (const char *name : {"a.png", "a.tif"}) {
        const Read stored = read(folder.file(name));
        for (std::size_t i = 0; i < picture.pixels.size(); ++i)
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(stored.values[3 * i + std::size_t(c)], shown(picture.pixels[i][c], -1), 1e-5) << name;
    }
    // Half: 11 bits.
    const Read half = read(folder.file("a.exr"));
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        ASSERT_NEAR(half.values[3 * i], picture.pixels[i].x, 0x1p-11f * picture.pixels[i].x + 1e-7f);
}

TEST(Image, LinearIntegersAreReadAsSuch) {
    const Folder folder;
    uint none = 0;
    while (tone_kinds()[none].name != std::string("none")) ++none;
    const Picture picture = ramp();
    write_picture(folder.file("a.png"), picture, {.tone = none, .bits = {Bits::sixteen}});
    const Picture linear = read_picture(folder.file("a.png"));
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) ASSERT_NEAR(linear.pixels[i].x, std::min(picture.pixels[i].x, 1.0f), 1e-5f) << i;
}

TEST(Image, LowerQualityMakesSmallerJpegs) {
    const Folder folder;
    const auto size = [&](uint quality) {
        write_picture(folder.file("a.jpg"), ramp(), {.quality = quality});
        return fs::file_size(folder.file("a.jpg"));
    };
    EXPECT_LT(size(20), size(80));
    EXPECT_LT(size(80), size(98));
}

TEST(Image, AWindowKeepsItsPlaceInExr) {
    const Folder folder;
    Picture picture = ramp();
    picture.left = 100, picture.top = 7, picture.whole_width = 640, picture.whole_height = 480;
    for (const char *name : {"a.exr", "a.png", "a.tif"}) write_picture(folder.file(name), picture);
    const auto input = OIIO::ImageInput::open(folder.file("a.exr"));
    EXPECT_EQ(input->spec().x, 100);
    EXPECT_EQ(input->spec().y, 7);
    EXPECT_EQ(input->spec().full_x, 0);
    EXPECT_EQ(input->spec().full_width, 640);
    EXPECT_EQ(input->spec().full_height, 480);
    const Picture read = read_picture(folder.file("a.exr"));
    EXPECT_EQ(read.pixels, picture.pixels);
    EXPECT_EQ(read.left, 100u);
    EXPECT_EQ(read.top, 7u);
    EXPECT_EQ(read.whole_width, 640u);
    EXPECT_EQ(read.whole_height, 480u);
    for (const char *name : {"a.png", "a.tif"}) {
        EXPECT_EQ(read_picture(folder.file(name)).width, 64u) << name;
        EXPECT_EQ(read_picture(folder.file(name)).whole_width, 0u) << name;
    }
}

}  // namespace
}  // namespace brandung
