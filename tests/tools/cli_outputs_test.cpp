/// Pictures as the program writes them: formats, metadata, crops, AOVs, exposure, and pictures so far.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/tools/runs.h"
#include "tests/tools/scenes.h"
#include "tests/tools/stored_picture.h"

namespace {

using nlohmann::json;

/// IEC 61966-2-1, in 8 bits.
int srgb_byte(double linear) {
    const double clamped = std::min(std::max(linear, 0.0), 1.0);
    const double encoded = clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * std::pow(clamped, 1 / 2.4) - 0.055;
    return static_cast<int>(std::lround(255 * encoded));
}

}  // namespace

TEST(Outputs, ExrHasThePicturesSizeFloatsAndLinearColour) {
    const TemporaryFolder folder;
    render_quietly({folder.write("scene.json", native_scene()), "-o", folder.path("out.exr")});
    const StoredPicture picture = read_stored(folder.path("out.exr"));
    EXPECT_EQ(picture.spec.width, 32);
    EXPECT_EQ(picture.spec.height, 24);
    EXPECT_EQ(picture.spec.nchannels, 3);
    EXPECT_EQ(picture.spec.format, OIIO::TypeDesc::FLOAT);
    EXPECT_EQ(picture.spec.channelnames, (std::vector<std::string>{"R", "G", "B"}));
    // The middle of the sphere: ambient 0.1 * 0.5, and light from above right.
    const std::size_t middle = 3 * (12 * 32 + 16);
    EXPECT_GT(picture.values[middle], 0.1f);
    EXPECT_EQ(picture.values[0], 0) << "background";
}

TEST(Outputs, ExrNamesProgramSettingsSceneAndStatistics) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    render_quietly({scene, "-o", folder.path("out.exr"), "--spp", "2", "--seed", "3", "--max-depth", "4", "--set", "integrator.threshold=0.25"});
    const StoredPicture picture = read_stored(folder.path("out.exr"));
    EXPECT_TRUE(picture.text("Software").starts_with("brandung 0.")) << picture.text("Software");
    EXPECT_EQ(picture.text("brandung:scene"), scene);
    EXPECT_EQ(picture.text("brandung:integrator"), "whitted");
    EXPECT_EQ(picture.text("brandung:max_depth"), "4");
    EXPECT_EQ(picture.text("brandung:threshold"), "0.25");
    EXPECT_EQ(picture.text("brandung:spp"), "2");
    EXPECT_EQ(picture.text("brandung:seed"), "3");
    EXPECT_EQ(picture.text("brandung:pixel"), "center");
    EXPECT_EQ(picture.text("brandung:camera"), "camera");
    EXPECT_EQ(picture.text("brandung:interrupted"), "");
    const json statistics = json::parse(picture.text("brandung:statistics"));
    EXPECT_EQ(statistics.at("interrupted"), false);
    EXPECT_EQ(statistics.at("rays").at("camera"), 32 * 24 * 2);
    EXPECT_EQ(statistics.at("accelerator"), "wide_bvh");
    EXPECT_GT(statistics.at("seconds").at("render"), 0);
    for (const char *name : {"write", "total"}) EXPECT_FALSE(statistics.at("seconds").contains(name)) << name << " is not known yet";
}

/// The hash tells whether two pictures are of the same scene, wherever its file lies.
TEST(Outputs, ExrHasTheScenesHash) {
    const TemporaryFolder folder;
    const auto hash = [&](const std::string &name, const std::string &text) {
        render_quietly({folder.write(name, text), "-o", folder.path("out.exr")});
        return read_stored(folder.path("out.exr")).text("brandung:scene_hash");
    };
    const std::string one = hash("one.json", native_scene());
    EXPECT_NE(one, "");
    EXPECT_EQ(one, hash("copy.json", native_scene()));
    EXPECT_NE(one, hash("other.json", native_scene(R"({"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1.0000001})")));
}

TEST(Outputs, PngIsTheExrThroughExposureAndTheSrgbCurve) {
    const TemporaryFolder folder;
    render_quietly({folder.write("scene.json", native_scene()), "--size", "37x23", "--spp", "4", "--set", "film.exposure=1.5", "-o",
                    folder.path("out.exr"), "-o", folder.path("out.png")});
    const StoredPicture linear = read_stored(folder.path("out.exr")), shown = read_stored(folder.path("out.png"));
    EXPECT_EQ(shown.spec.width, 37);
    EXPECT_EQ(shown.spec.height, 23);
    EXPECT_EQ(shown.spec.nchannels, 3);
    EXPECT_EQ(shown.spec.format, OIIO::TypeDesc::UINT8);
    ASSERT_EQ(shown.values.size(), linear.values.size());
    std::size_t between = 0;
    for (std::size_t i = 0; i < linear.values.size(); ++i) {
        const int byte = static_cast<int>(std::lround(255 * shown.values[i]));
        // The program's curve is computed in float: one step off where the exact value lies at the border between two.
        ASSERT_NEAR(byte, srgb_byte(linear.values[i] * std::exp2(1.5)), 1) << "value " << i;
        between += byte > 0 && byte < 255;
    }
    EXPECT_GT(between, 100u) << "the picture has values that test the curve";
}

/// Pixel for pixel, on every machine.
/// In a part that has both spheres, the floor, a shadow and the sky; a crop has the bits of the whole.
TEST(Outputs, TheReadmesPictureIsWhatTheDemoRenders) {
    const TemporaryFolder folder;
    constexpr std::size_t left = 180, top = 200, right = 340, bottom = 320;
    render_quietly({BRANDUNG_SOURCE_DIR "/scene/examples/whitted_1980.json", "--crop", fmt::format("{},{},{},{}", left, top, right, bottom), "-o",
                    folder.path("demo.png")});
    const StoredPicture shown = read_stored(BRANDUNG_SOURCE_DIR "/scene/pictures/whitted_1980.png"), demo = read_stored(folder.path("demo.png"));
    ASSERT_EQ(demo.spec.width, right - left);
    const std::size_t channels = shown.spec.nchannels, row = (right - left) * channels;
    for (std::size_t y = top; y < bottom; ++y)
        for (std::size_t i = 0; i < row; ++i)
            ASSERT_EQ(demo.values[(y - top) * row + i], shown.values[(y * shown.spec.width + left) * channels + i]) << y << " " << i;
}

/// Two of them, in their own size; tools/guide_pictures renders all of them.
TEST(Outputs, TheGuidesPicturesAreWhatItsExamplesRender) {
    const TemporaryFolder folder;
    for (const std::string name : {"light_mirror_table", "primitives"}) {
        const StoredPicture shown = read_stored(BRANDUNG_SOURCE_DIR "/scene/pictures/" + name + ".png");
        render_quietly({BRANDUNG_SOURCE_DIR "/scene/examples/" + name + ".json", "--size",
                        std::to_string(shown.spec.width) + "x" + std::to_string(shown.spec.height), "-o", folder.path("rendered.png")});
        EXPECT_EQ(shown.values, read_stored(folder.path("rendered.png")).values) << name;
    }
}

TEST(Outputs, SeveralAtOnceAreTheSamePicture) {
    const TemporaryFolder folder;
    render_quietly({folder.write("scene.json", native_scene()), "-o", folder.path("a.exr"), "-o", folder.path("b.exr"), "-o", folder.path("c.tif"),
                    "-o", folder.path("d.hdr"), "-o", folder.path("e.jpg")});
    const StoredPicture exr = read_stored(folder.path("a.exr"));
    EXPECT_EQ(exr.values, read_stored(folder.path("b.exr")).values);
    EXPECT_EQ(exr.values, read_stored(folder.path("c.tif")).values);
    for (const char *name : {"d.hdr", "e.jpg"}) EXPECT_EQ(read_stored(folder.path(name)).spec.width, 32) << name;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.exr", "b.exr", "c.tif", "d.hdr", "e.jpg", "scene.json"}));
}

TEST(Outputs, ACropIsADataWindowInExrAndAPictureOfItsSizeElsewhere) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    render_quietly({scene, "-o", folder.path("whole.exr")});
    render_quietly(
        {scene, "--crop", "10,5,22,15", "-o", folder.path("part.exr"), "-o", folder.path("part.png"), "--stats", folder.path("stats.json")});
    const StoredPicture whole = read_stored(folder.path("whole.exr")), part = read_stored(folder.path("part.exr"));
    EXPECT_EQ(part.spec.x, 10);
    EXPECT_EQ(part.spec.y, 5);
    EXPECT_EQ(part.spec.width, 12);
    EXPECT_EQ(part.spec.height, 10);
    EXPECT_EQ(part.spec.full_width, 32);
    EXPECT_EQ(part.spec.full_height, 24);
    for (std::size_t y = 0; y < 10; ++y)
        for (std::size_t i = 0; i < 36; ++i) ASSERT_EQ(part.values[36 * y + i], whole.values[3 * (32 * (y + 5) + 10) + i]);
    EXPECT_EQ(read_stored(folder.path("part.png")).spec.width, 12);
    EXPECT_EQ(json::parse(read_file(folder.path("stats.json"))).at("window"), (json{10, 5, 22, 15}));
}

TEST(Outputs, AovsAreChannelsOfTheExr) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    render_quietly({scene, "-o", folder.path("plain.exr")});
    render_quietly(
        {scene, "--aov", "normal,depth,samples", "-o", folder.path("a.exr"), "-o", folder.path("a.png"), "--stats", folder.path("stats.json")});
    const StoredPicture plain = read_stored(folder.path("plain.exr")), picture = read_stored(folder.path("a.exr"));
    std::vector<std::string> names = picture.spec.channelnames;
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"B", "G", "N.X", "N.Y", "N.Z", "R", "depth.Z", "samples"}));
    EXPECT_EQ(picture.spec.channelformat(picture.spec.channelindex("samples")), OIIO::TypeDesc::UINT);
    EXPECT_EQ(picture.spec.channelformat(picture.spec.channelindex("depth.Z")), OIIO::TypeDesc::FLOAT);
    EXPECT_EQ(read_stored(folder.path("a.png")).spec.nchannels, 3);
    const auto value = [&](std::size_t pixel, const char *name) {
        return picture.values[8 * pixel + static_cast<std::size_t>(picture.spec.channelindex(name))];
    };
    for (std::size_t i = 0; i < 32 * 24; ++i) {
        ASSERT_EQ(value(i, "R"), plain.values[3 * i]);
        ASSERT_EQ(value(i, "B"), plain.values[3 * i + 2]);
    }
    // The eye is 4 away from the middle of a sphere of radius 1; the ray passes half a pixel, 0.06 at most, from its pole.
    const std::size_t middle = 12 * 32 + 16;
    EXPECT_NEAR(value(middle, "N.Z"), 1, 0.01);
    EXPECT_NEAR(value(middle, "depth.Z"), 3, 0.01);
    EXPECT_TRUE(std::isinf(value(0, "depth.Z"))) << "nothing is hit";
    EXPECT_EQ(value(0, "N.Z"), 0);
    const Finished without_exr = run_program({"render", scene, "--aov", "all", "-o", folder.path("b.png")});
    EXPECT_EQ(without_exr.status, 2);
    EXPECT_NE(without_exr.err.find("--aov"), std::string::npos) << without_exr.err;
    const Finished unknown = run_program({"render", scene, "--aov", "colour", "-o", folder.path("b.exr")});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_NE(unknown.err.find("/film/aovs/0"), std::string::npos) << unknown.err;
}

TEST(Outputs, BitsAndQualityGoToTheFormatsThatHaveThem) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    render_quietly(
        {scene, "--bits", "16,half", "--quality", "50", "-o", folder.path("a.png"), "-o", folder.path("b.exr"), "-o", folder.path("c.jpg")});
    EXPECT_EQ(read_stored(folder.path("a.png")).spec.format, OIIO::TypeDesc::UINT16);
    EXPECT_EQ(read_stored(folder.path("b.exr")).spec.format, OIIO::TypeDesc::HALF);
    for (const auto &arguments : {std::vector<std::string>{"--bits", "half"}, {"--bits", "12"}, {"--quality", "50"}, {"--quality", "101"}}) {
        std::vector<std::string> all = {"render", scene, "-o", folder.path("d.png")};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Finished run = run_program(all);
        EXPECT_EQ(run.status, 2) << run.err;
        EXPECT_NE(run.err.find(arguments[0]), std::string::npos) << run.err;
    }
}

/// What it says can be pasted, and gives the same picture.
TEST(Outputs, AutomaticExposureSaysWhatItChose) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    const Finished run = run_program({"render", "--quiet", scene, "--exposure", "auto", "--tone", "filmic", "-o", folder.path("a.png")});
    expect_success(run);
    ASSERT_TRUE(run.err.starts_with("exposure: --exposure ")) << run.err;
    const std::string chosen = run.err.substr(21, run.err.size() - 22);
    render_quietly({scene, "--exposure", chosen, "--tone", "filmic", "-o", folder.path("b.png")});
    EXPECT_EQ(read_stored(folder.path("a.png")).values, read_stored(folder.path("b.png")).values);
    EXPECT_EQ(read_stored(folder.path("a.png")).text("brandung:exposure"), chosen);
    EXPECT_EQ(read_stored(folder.path("a.png")).text("brandung:tone"), "filmic");
    render_quietly({scene, "--exposure", "-3", "-o", folder.path("b.png")});
    EXPECT_NE(read_stored(folder.path("a.png")).values, read_stored(folder.path("b.png")).values);
}

/// A render of hours that is killed once a picture is there: that is complete, and says what it is.
TEST(Outputs, PicturesSoFarAreSavedWhileRendering) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene()), out = folder.path("out.exr");
    RunOptions options;
    options.signal_when = [&](const std::string &) { return std::filesystem::exists(out) ? SIGKILL : 0; };
    const Finished run = run_program({"render", scene, "--spp", "16000000", "--save-every", "0.2", "-o", out}, options);
    EXPECT_EQ(run.signal, SIGKILL) << run.err;
    const StoredPicture picture = read_stored(out);
    EXPECT_EQ(picture.text("brandung:unfinished"), "true");
    EXPECT_EQ(picture.text("brandung:interrupted"), "");
    EXPECT_NE(picture.text("brandung:samples").find(" of 12288000000 samples"), std::string::npos) << picture.text("brandung:samples");
    // The middle is as bright as with one sample, not darker by those that are missing.
    EXPECT_GT(picture.values[3 * (12 * 32 + 16)], 0.1f);
}

TEST(Outputs, AnOldPictureIsReplaced) {
    const TemporaryFolder folder;
    const std::string out = folder.write("out.exr", "old");
    render_quietly({folder.write("scene.json", native_scene()), "-o", out});
    EXPECT_EQ(read_stored(out).spec.width, 32);
}
