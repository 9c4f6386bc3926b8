/// The program's subcommands where nothing is wrong: what they print, write and return.
#include <OpenImageIO/imageio.h>
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

}  // namespace

TEST(Cli, HelpNamesEverySubcommandOnStandardOutput) {
    const Finished run = run_program({"--help"});
    expect_success(run);
    EXPECT_EQ(run.err, "");
    for (const char *command : {"render", "info", "check", "inspect", "devices", "compare"})
        EXPECT_NE(run.out.find(command), std::string::npos) << command;
}

TEST(Cli, HelpOfRenderNamesEveryOption) {
    const Finished run = run_program({"render", "--help"});
    expect_success(run);
    for (const char *option :
         {"--output",  "--integrator", "--accelerator", "--spp",   "--size",      "--seed",          "--pixel",      "--camera", "--background",
          "--from",    "--at",         "--up",          "--fov",   "--max-depth", "--light-samples", "--shadows",    "--set",    "--crop",
          "--aov",     "--filter",     "--exposure",    "--tone",  "--bits",      "--quality",       "--save-every", "--device", "--batch",
          "--threads", "--stats",      "--explain",     "--quiet", "--preview",   "--preview-hold"})
        EXPECT_NE(run.out.find(option), std::string::npos) << option;
}

TEST(Cli, VersionIsOneLineWithTheProjectsNumber) {
    const Finished run = run_program({"--version"});
    expect_success(run);
    EXPECT_EQ(lines_of(run.out).size(), 1u);
    EXPECT_TRUE(run.out.starts_with("brandung 0.")) << run.out;
    EXPECT_EQ(run.err, "");
}

TEST(Cli, DevicesMarksTheOneThatIsTaken) {
    const Finished text = run_program({"devices"});
    expect_success(text);
    std::size_t marked = 0;
    for (const std::string &line : lines_of(text.out)) marked += line.starts_with("* ");
    EXPECT_EQ(marked, 1u) << text.out;

    const Finished as_json = run_program({"devices", "--json"});
    expect_success(as_json);
    const json devices = json::parse(as_json.out);
    std::size_t chosen = 0;
    for (const json &device : devices) {
        chosen += device.at("chosen").get<bool>();
        EXPECT_FALSE(device.at("name").get<std::string>().empty());
        EXPECT_GT(device.at("compute_units").get<int>(), 0);
        EXPECT_GT(device.at("memory_bytes").get<std::uint64_t>(), 0u);
    }
    EXPECT_EQ(chosen, 1u);
    EXPECT_EQ(devices.size(), lines_of(text.out).size());
}

TEST(Cli, InfoCountsWhatTheSceneContains) {
    const TemporaryFolder folder;
    const std::string scene =
        folder.write("scene.nff", nff_scene("s 0 0 0 1\nf 1 0 0 1 0 1 0 1\nc 0 0 0 1\n0 1 0 0.5\np 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"));
    const Finished run = run_program({"info", scene, "--json"});
    expect_success(run);
    EXPECT_EQ(run.err, "");
    const json info = json::parse(run.out), counts = info.at("scene");
    EXPECT_EQ(counts.at("primitives"), 4);  // sphere, cone, and two triangles of the square
    EXPECT_EQ(counts.at("triangles"), 2);
    EXPECT_EQ(counts.at("lights"), 1);
    EXPECT_EQ(counts.at("materials"), 2);
    EXPECT_EQ(info.at("film").at("width"), 32);
    EXPECT_EQ(info.at("film").at("height"), 24);
    for (const char *part : {"scene_bytes", "wave_bytes", "film_bytes"}) EXPECT_GT(info.at("memory").at(part).get<std::uint64_t>(), 0u) << part;

    const Finished text = run_program({"info", scene});
    expect_success(text);
    for (const char *line : {"\n  has     4 primitives (1 frustum, 1 sphere, 2 triangles)", ", 1 light (1 point), 2 materials, 1 camera\n", " MiB (",
                             "uses    primitive sphere", "skips   light directional"})
        EXPECT_NE(text.out.find(line), std::string::npos) << line << " in\n" << text.out;
}

/// Info describes the render that the same options would start.
TEST(Cli, InfoTakesTheOptionsOfRender) {
    const TemporaryFolder folder;
    const std::string stats = folder.path("stats.json");
    const std::vector<std::string> options = {"--size",        "50x40", "--set",       "materials.0.reflection=0.5",
                                              "--batch",       "8192",  "--max-depth", "2",
                                              "--accelerator", "none",  "--camera",    "camera"};
    std::vector<std::string> render_arguments = {"-o", folder.path("out.png"), "--quiet", "--stats", stats},
                             info_arguments = {"info", folder.path("scene.json"), "--json"};
    render_arguments.insert(render_arguments.end(), options.begin(), options.end());
    info_arguments.insert(info_arguments.end(), options.begin(), options.end());
    expect_success(render_native(folder, render_arguments));
    const Finished run = run_program(info_arguments);
    expect_success(run);
    const json info = json::parse(run.out), rendered = json::parse(read_file(stats));
    EXPECT_EQ(info.at("film").at("width"), 50);
    EXPECT_EQ(info.at("camera"), "camera");
    for (const char *name : {"memory", "features", "accelerator", "scene"}) EXPECT_EQ(info.at(name), rendered.at(name)) << name;
    std::vector<std::string> kernels = info.at("kernels");
    for (const json &kernel : rendered.at("kernels")) EXPECT_EQ(std::count(kernels.begin(), kernels.end(), kernel.at("name")), 1) << kernel;
    EXPECT_EQ(std::count(kernels.begin(), kernels.end(), "spawn_whitted"), 1);
    const json matte = json::parse(run_program({"info", folder.path("scene.json"), "--json"}).out);
    kernels = matte.at("kernels");
    EXPECT_EQ(std::count(kernels.begin(), kernels.end(), "spawn_whitted"), 0) << "nothing reflects";
}

TEST(Cli, MoreThanEightMediaAreMentioned) {
    const TemporaryFolder folder;
    std::string spheres;
    for (int i = 1; i <= 10; ++i) spheres += "f 1 1 1 0 0 1 1 1.5\ns 0 0 0 0." + std::to_string(i) + "\n";
    const Finished run = run_program({"render", folder.write("scene.nff", nff_scene(spheres)), "-o", folder.path("out.png"), "--quiet", "--explain",
                                      "--max-depth", "20", "--stats", folder.path("stats.json")});
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

TEST(Cli, ExplainSaysWhatIsUsedAndWhatIsSkippedAndWhy) {
    const TemporaryFolder folder;
    const Finished run = render_native(folder, {"-o", folder.path("out.exr"), "--quiet", "--explain"});
    expect_success(run);
    EXPECT_NE(run.out.find("uses    primitive sphere\n"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("uses    accelerator wide_bvh\n"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("skips   primitive triangle: the scene has none\n"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("skips   spawn_whitted: no material reflects or transmits\n"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("skips   filter_shadow_rays: shadows are opaque; --shadows filtered asks for others\n"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("\ncannot show indirect light: "), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find("cannot show light through"), std::string::npos) << "nothing is transparent: " << run.out;
    EXPECT_EQ(run.err, "");
}

TEST(Cli, ExplainNamesPicturesColoursAndNormals) {
    const TemporaryFolder folder;
    write_picture(folder.path("sky.exr"), {1, 1, {Spectrum(1)}, {}});
    const std::string mesh = R"({"type": "triangle_mesh", "material": "grey", "positions": [[0,0,0], [1,0,0], [0,1,0]], "indices": [0,1,2], )";
    const auto explained = [&](const std::string &object, const std::vector<std::string> &more = {}) {
        std::vector<std::string> arguments = {"info", folder.write("scene.json", native_scene(object))};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program(arguments).out;
    };
    const std::string plain = explained(mesh + R"("uvs": [[0,0], [1,0], [0,1]]})");
    for (const char *feature : {"1 texture", "vertex colours", "picture as background", "shading normals"})
        EXPECT_EQ(plain.find(std::string("uses    ") + feature), std::string::npos) << plain;
    const std::string all =
        explained(mesh + R"("uvs": [[0,0], [1,0], [0,1]], "colors": [[1,0,0], [0,1,0], [0,0,1]], "normals": [[0,0,1], [0,1,1], [1,0,1]]})",
                  {"--background", folder.path("sky.exr"), "--set", "materials.0.diffuse={\"texture\": \"sky.exr\"}"});
    for (const char *feature : {"1 texture\n", "vertex colours\n", "picture as background\n", "shading normals\n"})
        EXPECT_NE(all.find(std::string("uses    ") + feature), std::string::npos) << feature << all;
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
    expect_success(render_native(folder, {"-o", folder.path("a.exr"), "--quiet", "--size", "20x10", "--spp", "4", "--seed", "7", "--max-depth", "3",
                                          "--accelerator", "none", "--integrator", "whitted", "--stats", stats}));
    const json by_option = json::parse(read_file(stats));
    expect_success(
        render_native(folder, {"-o", folder.path("b.exr"), "--quiet", "--set", "film.width=20", "--set", "film.height=10", "--set", "film.spp=4",
                               "--set", "film.seed=7", "--set", "integrator.max_depth=3", "--set", "accelerator=none", "--stats", stats}));
    const json by_setting = json::parse(read_file(stats));
    for (const char *name : {"width", "height", "spp", "seed", "accelerator", "integrator", "rays"})
        EXPECT_EQ(by_option.at(name), by_setting.at(name));
    EXPECT_EQ(by_option.at("width"), 20);
    EXPECT_EQ(by_option.at("height"), 10);
    EXPECT_EQ(by_option.at("spp"), 4);
    EXPECT_EQ(by_option.at("seed"), 7);
    EXPECT_EQ(by_option.at("accelerator"), "none");
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

/// Colour of the upper left pixel of `folder`'s small scene, where nothing but the background is seen.
Spectrum corner_with_background(const TemporaryFolder &folder, const std::string &scene, const std::string &background) {
    expect_success(run_program({"render", scene, "--quiet", "--background", background, "-o", folder.path("corner.exr")}));
    return read_picture(folder.path("corner.exr")).pixels.at(0);
}

/// Picture i of n is what the camera sees that has been turned by i / n of a circle; the first is that of the scene's camera.
TEST(Cli, ATurntableIsASequenceOfTurnedCameras) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    expect_success(run_program({"render", scene, "--quiet", "--from", "0,1,5", "--at", "0,0,0", "--turntable", "4", "-o", folder.path("t.exr")}));
    expect_success(run_program({"render", scene, "--quiet", "--from", "0,1,5", "--at", "0,0,0", "-o", folder.path("front.exr")}));
    expect_success(run_program({"render", scene, "--quiet", "--from", "0,1,-5", "--at", "0,0,0", "-o", folder.path("behind.exr")}));
    EXPECT_EQ(folder.names(),
              (std::vector<std::string>{"behind.exr", "front.exr", "scene.json", "t_000.exr", "t_001.exr", "t_002.exr", "t_003.exr"}));
    const auto pixels = [&](const char *name) { return read_picture(folder.path(name)).pixels; };
    EXPECT_EQ(pixels("t_000.exr"), pixels("front.exr"));
    const auto turned = pixels("t_002.exr"), behind = pixels("behind.exr");
    ASSERT_EQ(turned.size(), behind.size());
    double difference = 0;  // sines of pi are no zeros
    for (std::size_t i = 0; i < turned.size(); ++i) difference += glm::length(turned[i] - behind[i]) / double(turned.size());
    EXPECT_LT(difference, 0.01);
}

/// A cube looks the same from all four sides if its light goes round with the camera.
TEST(Cli, ATurntablesHeadlightGoesWithTheCamera) {
    const TemporaryFolder folder;
    const std::string cube = folder.write("cube.obj", R"(v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 3 4 8 7
f 2 3 7 6
f 1 5 8 4
)");
    expect_success(run_program({"render", cube, "--quiet", "--size", "40x30", "--turntable", "4", "-o", folder.path("t.exr")}));
    const auto mean = [&](const char *name) {
        double sum = 0;
        for (const vec3 &pixel : read_picture(folder.path(name)).pixels) sum += pixel.x;
        return sum / (40 * 30);
    };
    const double front = mean("t_000.exr");
    EXPECT_GT(front, 0.1);
    for (const char *side : {"t_001.exr", "t_002.exr", "t_003.exr"}) EXPECT_NEAR(mean(side), front, 0.005 * front);
}

TEST(Cli, CheckReportsWithoutADevice) {
    const TemporaryFolder folder;
    const Finished run = run_program({"check", folder.write("scene.json", native_scene())});
    expect_success(run);
    EXPECT_TRUE(run.out.ends_with("scene.json: 1 primitive (1 sphere), 1 light (1 point), 1 material, 1 camera\n")) << run.out;
    EXPECT_EQ(run.err, "");
    const Finished bad = run_program({"check", folder.write("bad.json", native_scene("", R"("integrator": {"type": "path"},)"))});
    EXPECT_EQ(bad.status, 1);
    EXPECT_NE(bad.err.find("bad.json:6: /integrator/type: there is no \"path\", only whitted"), std::string::npos) << bad.err;
    const Finished cut = run_program({"check", folder.write("cut.json", R"({"camera": )")});
    EXPECT_EQ(cut.status, 1);
    EXPECT_NE(cut.err.find("cut.json:1: "), std::string::npos) << cut.err;
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
