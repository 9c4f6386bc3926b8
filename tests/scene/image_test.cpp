#include "scene/image.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "scene/error.h"

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
    write_picture(file, picture, 1.5f);
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
        write_picture(folder.file("out.png"), picture, exposure);
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
        write_picture(folder.file(name), picture, 0);
        EXPECT_EQ(OIIO::ImageInput::open(folder.file(name))->spec().get_string_attribute("brandung:answer"), "42") << name;
    }
}

}  // namespace
}  // namespace brandung
