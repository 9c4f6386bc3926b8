/// Renders where nothing is wrong: what the program prints, writes and returns.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "scene/image.h"
#include "tests/tools/runs.h"
#include "tests/tools/scenes.h"

namespace {

using namespace brandung;
using nlohmann::json;

/// Colour of the upper left pixel of `folder`'s small scene, where nothing but the background is seen.
Spectrum corner_with_background(const TemporaryFolder &folder, const std::string &scene, const std::string &background) {
    expect_success(run_program({"render", scene, "--quiet", "--background", background, "-o", folder.path("corner.exr")}));
    return read_picture(folder.path("corner.exr")).pixels.at(0);
}

}  // namespace

TEST(Cli, MoreThanEightMediaAreMentioned) {
    const TemporaryFolder folder;
    std::string spheres;
    for (int i = 1; i <= 10; ++i) spheres += "f 1 1 1 0 0 1 1 1.5\ns 0 0 0 0." + std::to_string(i) + "\n";
    const Finished run = run_program({"render", folder.write("scene.nff", nff_scene(spheres)), "-o", folder.path("out.png"), "--quiet", "--explain",
                                      "--max-depth", "12", "--stats", folder.path("stats.json")});
    expect_success(run);
    EXPECT_NE(run.err.find(" times a ray entered a transparent body from within 8 others"), std::string::npos) << run.err;
    EXPECT_GT(json::parse(read_file(folder.path("stats.json"))).at("media_lost"), 0);
    EXPECT_NE(run.out.find("skips   more than 8 media"), std::string::npos) << run.out;
}

TEST(Cli, RenderWritesNothingButMessagesToStandardError) {
    const TemporaryFolder folder;
    const Finished run = render_native(folder, {"-o", folder.path("out.exr")});
    expect_success(run);
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find("memory: scene"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("100 %"), std::string::npos) << run.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"out.exr", "scene.json"}));
}

TEST(Cli, QuietRenderSaysNothing) {
    const TemporaryFolder folder;
    const Finished run = render_native(folder, {"-o", folder.path("out.exr"), "--quiet"});
    expect_success(run);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err, "");
}

TEST(Cli, WarningsAreCountedNotRepeated) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.nff", nff_scene("s 0 0 0 1\ns 0 0 0 0\ns 1 0 0 0\ns 2 0 0 0\n"));
    const Finished run = run_program({"render", scene, "-o", folder.path("out.png"), "--quiet"});
    expect_success(run);
    EXPECT_EQ(run.err, "warning: sphere of radius 0: left out (3 times, first at " + scene + ":11)\n");
}

TEST(Cli, NegativeRadiusInNffShowsTheInsideOnly) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.nff", nff_scene("s 0 0 0 -1\n"));
    const Finished run = run_program({"render", scene, "-o", folder.path("out.png"), "--quiet", "--stats", folder.path("stats.json")});
    expect_success(run);
    const json rays = json::parse(read_file(folder.path("stats.json"))).at("rays");
    EXPECT_GT(rays.at("camera_hits").get<int>(), 0);
    EXPECT_EQ(rays.at("shadow").get<int>(), rays.at("shadow_hits").get<int>())
        << "rays to the light, which is outside, pass the back only from inside";
}

/// Settings on the command line are those of the scene file: both ways give the same picture.
TEST(Cli, OptionsAreSettingsOfTheScene) {
    const TemporaryFolder folder;
    const std::string stats = folder.path("stats.json");
    expect_success(
        render_native(folder, {"-o", folder.path("a.exr"), "--quiet", "--size", "20x10", "--spp", "4", "--seed", "7", "--max-depth", "3",
                               "--accelerator", "wide_bvh", "--accelerator-quality", "high", "--integrator", "whitted", "--stats", stats}));
    const json by_option = json::parse(read_file(stats));
    expect_success(render_native(folder, {"-o", folder.path("b.exr"), "--quiet", "--set", "film.width=20", "--set", "film.height=10", "--set",
                                          "film.spp=4", "--set", "film.seed=7", "--set", "integrator.max_depth=3", "--set", "accelerator=wide_bvh",
                                          "--set", "accelerator_quality=high", "--stats", stats}));
    const json by_setting = json::parse(read_file(stats));
    for (const char *name : {"width", "height", "spp", "seed", "accelerator", "accelerator_quality", "integrator", "rays"})
        EXPECT_EQ(by_option.at(name), by_setting.at(name));
    EXPECT_EQ(by_option.at("width"), 20);
    EXPECT_EQ(by_option.at("height"), 10);
    EXPECT_EQ(by_option.at("spp"), 4);
    EXPECT_EQ(by_option.at("seed"), 7);
    EXPECT_EQ(by_option.at("accelerator"), "wide_bvh");
    EXPECT_EQ(by_option.at("accelerator_quality"), "high");
    EXPECT_EQ(by_option.at("rays").at("camera"), 20 * 10 * 4);
}

TEST(Cli, SetReachesIntoArraysOfTheScene) {
    const TemporaryFolder folder;
    const Finished run =
        render_native(folder, {"-o", folder.path("out.exr"), "--quiet", "--set", "objects.0.radius=1000", "--stats", folder.path("s.json")});
    expect_success(run);
    EXPECT_EQ(json::parse(read_file(folder.path("s.json"))).at("rays").at("camera_hits"), 32 * 24) << "the eye is inside the sphere";
}

TEST(Cli, CameraIsChosenByName) {
    const TemporaryFolder folder;
    std::string text = native_scene();
    const std::string camera = R"("camera": {"from": [0, 0, 4], "at": [0, 0, 0], "fov": 40})";
    text.replace(text.find(camera), camera.size(), R"("cameras": [{"name": "front", "from": [0, 0, 4], "at": [0, 0, 0]},
        {"name": "away", "from": [0, 0, 4], "at": [0, 0, 8]}])");
    const std::string scene = folder.write("scene.json", text), stats = folder.path("stats.json");
    const auto hits = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"render", scene, "-o", folder.path("out.png"), "--quiet", "--stats", stats});
        expect_success(run_program(arguments));
        return json::parse(read_file(stats)).at("rays").at("camera_hits").get<int>();
    };
    EXPECT_GT(hits({}), 0) << "the first is the default";
    EXPECT_GT(hits({"--camera", "front"}), 0);
    EXPECT_EQ(hits({"--camera", "away"}), 0);
}

class ExampleScene : public testing::TestWithParam<std::string> {};

TEST_P(ExampleScene, RendersAndMentionsNoTrouble) {
    const TemporaryFolder folder;
    const Finished run = run_program({"render", std::string(BRANDUNG_SOURCE_DIR "/scene/examples/") + GetParam(), "-o", folder.path("out.png"),
                                      "--size", "40x30", "--spp", "1", "--quiet", "--stats", folder.path("stats.json")});
    expect_success(run);
    EXPECT_EQ(run.err, "");
    const json stats = json::parse(read_file(folder.path("stats.json")));
    EXPECT_GT(stats.at("rays").at("camera_hits").get<int>(), 0);
    EXPECT_GT(stats.at("rays").at("shadow").get<int>(), 0);
    EXPECT_EQ(stats.at("refused"), 0);
    EXPECT_EQ(stats.at("clamped"), 0);
}

namespace {

std::vector<std::string> example_names() {
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(BRANDUNG_SOURCE_DIR "/scene/examples"))
        if (entry.path().extension() == ".json" || entry.path().extension() == ".nff") names.push_back(entry.path().filename().string());
    return names;
}

}  // namespace

INSTANTIATE_TEST_SUITE_P(Cli, ExampleScene, testing::ValuesIn(example_names()), [](const auto &info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
});

TEST(Cli, MoreThreadsThanComputeUnitsAreMentioned) {
    const TemporaryFolder folder;
    const Finished run = render_native(folder, {"-o", folder.path("out.png"), "--quiet", "--threads", "9999"});
    expect_success(run);
    EXPECT_TRUE(run.err.starts_with("warning: --threads 9999: '")) << run.err;
}

/// What a mesh gets is said in a form that gives the same picture when it is asked for.
TEST(Cli, AMeshGetsACameraAndALight) {
    const TemporaryFolder folder;
    const std::string mesh = folder.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -1\nf 1 2 3\nf 1 3 4\n");
    const Finished run = run_program({"render", mesh, "-o", folder.path("a.ppm"), "--size", "32x32"});
    expect_success(run);
    std::string camera, scene;
    for (const std::string &line : lines_of(run.err)) {
        if (line.starts_with("camera: ")) camera = line.substr(8);
        if (line.starts_with("scene: ")) scene = line.substr(7);
    }
    expect_success(run_program({"render", folder.write("scene.json", scene), "-o", folder.path("c.ppm"), "--quiet"}));
    EXPECT_EQ(read_file(folder.path("a.ppm")), read_file(folder.path("c.ppm"))) << scene;
    std::vector<std::string> arguments = {"render", mesh, "-o", folder.path("b.ppm"), "--size", "32x32", "--quiet"};
    std::istringstream words(camera);
    for (std::string word; words >> word;) arguments.push_back(word);
    ASSERT_EQ(arguments.size(), 15u) << run.err;
    const Finished same = run_program(arguments);
    expect_success(same);
    EXPECT_EQ(same.err, "");
    EXPECT_EQ(read_file(folder.path("a.ppm")), read_file(folder.path("b.ppm")));
    arguments[8] = "5,5,5";
    expect_success(run_program(arguments));
    EXPECT_NE(read_file(folder.path("a.ppm")), read_file(folder.path("b.ppm")));
}

// 0x80 is 128 / 255 by the sRGB curve: ((128 / 255 + 0.055) / 1.055)^2.4 = 0.215861.
TEST(Cli, BackgroundIsAColourOrAPictureForEveryFormat) {
    const TemporaryFolder folder;
    write_picture(folder.path("sky.exr"), {2, 1, {{0.25f, 0.5f, 2}, {0.25f, 0.5f, 2}}, {}});
    for (const std::string &scene : {folder.write("scene.json", native_scene()), folder.write("scene.nff", nff_scene())}) {
        EXPECT_EQ(corner_with_background(folder, scene, "0.5"), Spectrum(0.5f));
        EXPECT_EQ(corner_with_background(folder, scene, "0.5,0.25,1"), Spectrum(0.5f, 0.25f, 1));
        const Spectrum hexadecimal = corner_with_background(folder, scene, "#ff8000");
        EXPECT_EQ(hexadecimal.x, 1);
        EXPECT_NEAR(hexadecimal.y, 0.215861f, 1e-6f);
        EXPECT_EQ(hexadecimal.z, 0);
        EXPECT_EQ(corner_with_background(folder, scene, folder.path("sky.exr")), Spectrum(0.25f, 0.5f, 2));
    }
}
