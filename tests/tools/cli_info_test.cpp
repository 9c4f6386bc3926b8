/// What the program tells without a picture, or beside it: help, version, devices, what scenes have and use.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scene/image.h"
#include "tests/tools/runs.h"
#include "tests/tools/scenes.h"

namespace {

using namespace brandung;
using nlohmann::json;

TEST(CliInfo, HelpNamesEverySubcommandOnStandardOutput) {
    const Finished run = run_program({"--help"});
    expect_success(run);
    EXPECT_EQ(run.err, "");
    for (const char *command : {"render", "info", "check", "inspect", "devices", "compare"})
        EXPECT_NE(run.out.find(command), std::string::npos) << command;
}

TEST(CliInfo, HelpOfRenderNamesEveryOption) {
    const Finished run = run_program({"render", "--help"});
    expect_success(run);
    for (const char *option : {"--output",  "--integrator",  "--accelerator", "--accelerator-quality",
                               "--spp",     "--size",        "--seed",        "--pixel",
                               "--camera",  "--background",  "--from",        "--at",
                               "--up",      "--fov",         "--max-depth",   "--light-samples",
                               "--shadows", "--set",         "--crop",        "--aov",
                               "--filter",  "--exposure",    "--tone",        "--bits",
                               "--quality", "--save-every",  "--device",      "--batch",
                               "--threads", "--stats",       "--explain",     "--quiet",
                               "--preview", "--preview-hold"})
        EXPECT_NE(run.out.find(option), std::string::npos) << option;
}

TEST(CliInfo, VersionIsOneLineWithTheProjectsNumber) {
    const Finished run = run_program({"--version"});
    expect_success(run);
    EXPECT_EQ(lines_of(run.out).size(), 1u);
    EXPECT_TRUE(run.out.starts_with("brandung 0.")) << run.out;
    EXPECT_EQ(run.err, "");
}

TEST(CliInfo, DevicesMarksTheOneThatIsTaken) {
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

TEST(CliInfo, InfoCountsWhatTheSceneContains) {
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
    for (const char *part : {"scene_bytes", "node_bytes", "block_bytes", "shading_bytes", "wave_bytes", "film_bytes"})
        EXPECT_GT(info.at("memory").at(part).get<std::uint64_t>(), 0u) << part;

    const Finished text = run_program({"info", scene});
    expect_success(text);
    for (const char *line : {"\n  has     4 primitives (1 frustum, 1 sphere, 2 triangles)", ", 1 light (1 point), 2 materials, 1 camera\n", " MiB (",
                             "\n          bytes per primitive: ", "uses    primitive sphere", "skips   light directional"})
        EXPECT_NE(text.out.find(line), std::string::npos) << line << " in\n" << text.out;
}

/// Info describes the render that the same options would start.
TEST(CliInfo, InfoTakesTheOptionsOfRender) {
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

TEST(CliInfo, ExplainSaysWhatIsUsedAndWhatIsSkippedAndWhy) {
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

TEST(CliInfo, ExplainNamesPicturesColoursAndNormals) {
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

TEST(CliInfo, ExplainSaysWhyTheBackgroundIsNoLight) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    const auto why = [&](const std::string &integrator) {
        const std::string out = run_program({"info", scene, "--integrator", integrator}).out, before = "skips   light environment: ";
        const std::size_t begin = out.find(before);
        return begin == std::string::npos ? out : out.substr(begin + before.size(), out.find('\n', begin) - begin - before.size());
    };
    EXPECT_EQ(why("path"), "the background is no picture");
    EXPECT_EQ(why("whitted"), "only paths ask for the light of a picture as background");
}

TEST(CliInfo, ExplainSaysThatInstancesShine) {
    const TemporaryFolder folder;
    const auto explained = [&](const std::string &emission) {
        const std::string group =
            R"("groups": [{"name": "g", "objects": [{"type": "sphere", "material": "grey", "center": [0, 3, 0], "radius": 1}]}],)";
        const std::string objects = R"({"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1}, {"type": "instance", "group": "g"})";
        const Finished run =
            run_program({"info", folder.write("scene.json", native_scene(objects, group)), "--set", "materials.0.emission=" + emission});
        expect_success(run);
        return run.out;
    };
    EXPECT_NE(explained("1").find("uses    emissive shapes of instances as lights\n"), std::string::npos);
    EXPECT_NE(explained("0").find("skips   emissive shapes of instances as lights: no light is a shape of one\n"), std::string::npos);
}

TEST(CliInfo, CheckReportsWithoutADevice) {
    const TemporaryFolder folder;
    const Finished run = run_program({"check", folder.write("scene.json", native_scene())});
    expect_success(run);
    EXPECT_TRUE(run.out.ends_with("scene.json: 1 primitive (1 sphere), 1 light (1 point), 1 material, 1 camera\n")) << run.out;
    EXPECT_EQ(run.err, "");
    const Finished bad = run_program({"check", folder.write("bad.json", native_scene("", R"("integrator": {"type": "radiosity"},)"))});
    EXPECT_EQ(bad.status, 1);
    EXPECT_NE(bad.err.find("bad.json:6: /integrator/type: there is no \"radiosity\", only whitted, path, distributed"), std::string::npos) << bad.err;
    const Finished cut = run_program({"check", folder.write("cut.json", R"({"camera": )")});
    EXPECT_EQ(cut.status, 1);
    EXPECT_NE(cut.err.find("cut.json:1: "), std::string::npos) << cut.err;
}

}  // namespace
