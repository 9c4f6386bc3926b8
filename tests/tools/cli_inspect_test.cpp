/// brandung inspect: the render's bits, and what it prints.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/tools/program.h"
#include "tests/tools/scenes.h"

namespace {

using nlohmann::json;

const std::vector<std::string> settings = {"--size", "16x12", "--spp", "4", "--set", "materials.0.reflection=0.5"};

Finished inspect(const TemporaryFolder &folder, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"inspect", folder.write("scene.json", native_scene())});
    arguments.insert(arguments.end(), settings.begin(), settings.end());
    return run_program(arguments);
}

json inspected(const TemporaryFolder &folder, const std::vector<std::string> &arguments) {
    const Finished run = inspect(folder, arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    return json::parse(run.out);
}

std::vector<std::string> names(const json &object) {
    std::vector<std::string> names;
    for (const auto &[name, value] : object.items()) names.push_back(name);
    return names;
}

using Names = std::vector<std::string>;

}  // namespace

/// Decimal and hexadecimal floats both carry all bits.
TEST(CliInspect, PixelHasTheBitsOfThePicture) {
    const TemporaryFolder folder;
    const json inspection = inspected(folder, {"8,6", "--json", "--samples", "all"});
    std::vector<std::string> render = {"render", folder.path("scene.json"), "-o", folder.path("out.exr"), "--quiet"};
    render.insert(render.end(), settings.begin(), settings.end());
    ASSERT_EQ(run_program(render).status, 0);
    const auto picture = OIIO::ImageInput::open(folder.path("out.exr"));
    std::vector<float> pixels(16 * 12 * 3);
    ASSERT_TRUE(picture && picture->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, pixels.data()));
    for (std::size_t c = 0; c < 3; ++c) {
        const float expected = pixels[(6 * 16 + 8) * 3 + c];
        EXPECT_GT(expected, 0);
        EXPECT_EQ(inspection["pixel"]["radiance"]["decimal"][c].get<float>(), expected);
        EXPECT_EQ(std::strtof(inspection["pixel"]["radiance"]["hex"][c].get<std::string>().c_str(), nullptr), expected);
    }
    EXPECT_EQ(inspection["samples"].size(), 4u);
    EXPECT_EQ(inspection["pixel"]["samples"], 4);
}

/// Names are a promise.
TEST(CliInspect, JsonHasTheseFields) {
    const TemporaryFolder folder;
    const json inspection = inspected(folder, {"8,6", "--json"});
    EXPECT_EQ(names(inspection),
              (Names{"height", "integrator", "max_depth", "pixel", "samples", "scene", "seed", "splat", "spp", "threshold", "width", "x", "y"}));
    EXPECT_EQ(names(inspection["pixel"]), (Names{"fixed_point", "radiance", "samples"}));
    ASSERT_EQ(inspection["samples"].size(), 1u);
    const json &sample = inspection["samples"][0], &ray = sample["ray"], &light = ray["lights"][0], &child = ray["children"][0];
    EXPECT_EQ(names(sample), (Names{"number", "ray", "sum", "weighed"}));
    EXPECT_EQ(names(ray), (Names{"children", "contributions", "depth", "direction", "hit", "interface", "kind", "lights", "number", "origin",
                                 "passed", "subtotal", "surface", "throughput", "tints", "unlit"}));
    EXPECT_EQ(names(ray["hit"]), (Names{"group", "instance", "kind", "material", "object", "place", "primitive", "primitive_of_shape", "shape",
                                        "source", "t", "u", "v"}));
    EXPECT_EQ(names(ray["surface"]),
              (Names{"cosine", "error", "geometric_normal", "material", "origin_lit_side", "origin_other_side", "point", "shading_normal", "side"}));
    EXPECT_EQ(names(ray["unlit"]), (Names{"ambient", "background", "emission", "radiance"}));
    EXPECT_EQ(names(ray["contributions"][0]), (Names{"fixed_point", "radiance", "refused", "rows", "running_total"}));
    EXPECT_EQ(names(light), (Names{"asked", "blocker", "contribution", "direction", "emissive", "filter", "kind", "light", "origin", "passed",
                                   "radiance", "row", "t_max", "visible", "why_not"}));
    EXPECT_EQ(names(child), (Names{"direction", "kind", "possible", "ray", "spawned", "weight", "why_not"}));
    EXPECT_EQ(ray["kind"], "camera");
    EXPECT_EQ(ray["hit"]["material"], "grey");
    EXPECT_EQ(ray["hit"]["kind"], "sphere");
    EXPECT_EQ(child["ray"]["kind"], "reflected");
    EXPECT_EQ(child["ray"]["hit"], nullptr) << "nothing is around the ball";
    EXPECT_EQ(sample["sum"], ray["subtotal"]);
    EXPECT_EQ(sample["sum"], child["ray"]["contributions"][0]["running_total"]) << "of the last ray";
    EXPECT_EQ(ray["throughput"], json::parse(R"({"decimal": [1.0, 1.0, 1.0], "hex": ["0x1p+0", "0x1p+0", "0x1p+0"]})"));
}

TEST(CliInspect, JsonOfPathsHasTheseFieldsToo) {
    const TemporaryFolder folder;
    const json inspection = inspected(folder, {"8,6", "--json", "--integrator", "path"});
    EXPECT_EQ(inspection["integrator"], "path");
    EXPECT_EQ(inspection["roulette_depth"], 4);
    const json &sample = inspection["samples"][0], &ray = sample["ray"], &light = ray["lights"][0], &child = ray["children"][0];
    EXPECT_EQ(names(ray["unlit"]), (Names{"ambient", "background", "emission", "radiance", "weight"}));
    EXPECT_EQ(ray["unlit"]["ambient"]["decimal"], json({0.0f, 0.0f, 0.0f})) << "paths know none";
    EXPECT_EQ(names(light), (Names{"asked",     "blocker",  "bsdf",   "bsdf_density", "chance",  "contribution", "density",
                                   "direction", "emissive", "filter", "irradiance",   "kind",    "light",        "origin",
                                   "passed",    "radiance", "row",    "t_max",        "visible", "weight",       "why_not"}));
    EXPECT_EQ(names(child), (Names{"bsdf", "chance", "density", "direction", "kind", "possible", "ray", "roulette", "spawned", "weight", "why_not"}));
    EXPECT_EQ(ray["children"].size(), 1u);
    EXPECT_EQ(light["density"], nullptr) << "a point has none";
    EXPECT_EQ(sample["sum"], ray["subtotal"]);
    EXPECT_FALSE(ray.contains("part"));
}

TEST(CliInspect, PartsOfBundlesAreTold) {
    const TemporaryFolder folder;
    const std::vector<std::string> distributed = {
        "8,6", "--integrator", "distributed", "--set", "integrator.bundles.diffuse=3", "--set", "integrator.bundles.glossy=3"};
    std::vector<std::string> as_json = distributed;
    as_json.push_back("--json");
    const json ray = inspected(folder, as_json)["samples"][0]["ray"];
    ASSERT_EQ(ray["children"].size(), 3u);
    for (int j = 0; j < 3; ++j) EXPECT_EQ(ray["children"][j]["ray"]["part"], json({{"number", j}, {"of", 3}}));
    EXPECT_EQ(ray["part"], json({{"number", 0}, {"of", 1}}));
    const Finished run = inspect(folder, distributed);
    EXPECT_NE(run.out.find("\nray 3: reflected, depth 2, part 2 of 3, meets nothing"), std::string::npos) << run.out;
}

TEST(CliInspect, TextOfPathsSaysHowTheyChose) {
    const TemporaryFolder folder;
    const Finished run = inspect(folder, {"8,6", "--integrator", "path"});
    EXPECT_EQ(run.status, 0) << run.err;
    for (const char *part : {", path, max_depth ", ", roulette_depth 4\n", "  chance           1 [0x1p+0]", "  BSDF x cosine  ", "  BSDF's density ",
                             "  chance to go on  1 [0x1p+0]; roulette "})
        EXPECT_NE(run.out.find(part), std::string::npos) << part << " in\n" << run.out;
}

TEST(CliInspect, InterfacesHaveMediaOnBothSides) {
    const TemporaryFolder folder;
    const json inspection = inspected(folder, {"8,6", "--json", "--set", "materials.0.transmission=1"});
    const json &ray = inspection["samples"][0]["ray"], &interface = ray["interface"];
    EXPECT_EQ(names(interface), (Names{"cosine_squared_beyond", "eta", "media_before", "media_behind", "total_internal_reflection"}));
    EXPECT_EQ(interface["media_before"], json::array());
    EXPECT_EQ(interface["media_behind"], json::parse(R"([{"material": "grey", "times": 1}])"));
    EXPECT_EQ(ray["children"].size(), 2u);
}

/// A ball of the group, moved by 1 towards the eye and made red, hides a lamp of 2 x 2 strata behind it from what is seen of it.
TEST(CliInspect, ThingsHaveTheirPlacesInTheFile) {
    const TemporaryFolder folder;
    const std::string scene = native_scene(R"({"type": "sphere", "material": "lamp", "center": [0, 0, -9], "radius": 0.5},
    {"type": "instance", "group": "pair", "transform": [{"translate": [0, 0, 1]}], "material": "red"})",
                                           R"(
  "groups": [{"name": "pair", "objects": [
    {"type": "sphere", "material": "grey", "center": [0, 90, 0], "radius": 1},
    {"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1}
  ]}],)");
    const std::string grey = R"({"name": "grey", "type": "whitted", "diffuse": 0.5})";
    std::string text = scene;
    text.replace(text.find(grey), grey.size(), grey + R"(, {"name": "red", "type": "whitted"}, {"name": "lamp", "type": "whitted", "emission": 9})");
    const std::string file = folder.write("scene.json", text);
    const Finished run = run_program({"inspect", file, "15,11", "--json", "--light-samples", "2"});
    ASSERT_EQ(run.status, 0) << run.err;
    const json ray = json::parse(run.out)["samples"][0]["ray"], hit = ray["hit"];
    const auto line_of = [&](const std::string &what) {
        return std::to_string(1 + std::count(text.begin(), text.begin() + long(text.find(what)), '\n'));
    };
    EXPECT_EQ(hit["primitive"], 2) << "after that of the world and the group's first";
    EXPECT_EQ(hit["group"], "pair");
    EXPECT_EQ(hit["shape"], 1);
    EXPECT_EQ(hit["object"], 1);
    EXPECT_EQ(hit["material"], "red");
    EXPECT_EQ(hit["place"], file + ":" + line_of(R"("center": [0, 0, 0])") + ": /groups/0/objects/1");
    EXPECT_EQ(hit["instance"], json({{"number", 0}, {"object", 1}, {"place", file + ":" + line_of("\"instance\"") + ": /objects/1"}}));
    ASSERT_EQ(ray["lights"].size(), 5u);
    EXPECT_EQ(ray["lights"][0]["light"], 0);
    EXPECT_EQ(ray["lights"][0]["emissive"], nullptr);
    const json &lamp = ray["lights"][3];
    EXPECT_EQ(lamp["row"], 3);
    EXPECT_EQ(lamp["light"], nullptr);
    EXPECT_EQ(lamp["emissive"]["material"], "lamp");
    EXPECT_EQ(lamp["emissive"]["place"], file + ":" + line_of("\"lamp\", \"center\"") + ": /objects/0");
    EXPECT_EQ(lamp["emissive"]["stratum"], json({{"column", 0}, {"row", 1}, {"rows", 2}}));
    EXPECT_EQ(lamp["asked"], false);
}

/// From a wall behind, through two panes, to the light.
TEST(CliInspect, FacesOnTheWayAndLinesOfFilesAreTold) {
    const TemporaryFolder folder;
    folder.write("wall.obj", "v -9 -9 -5\nv 9 -9 -5\n\nv 0 18 -5\nf 1 2 3\n");
    const std::string scene = folder.write("scene.json", native_scene(R"(
    {"type": "polygon", "material": "glass", "vertices": [[-1, 1, -5], [2, 1, -5], [2, 1, -1], [-1, 1, -1]]},
    {"type": "polygon", "material": "glass", "vertices": [[-1, 2, -5], [2, 2, -5], [2, 2, -1], [-1, 2, -1]]},
    {"type": "mesh", "file": "wall.obj", "material": "grey"})"));
    const std::string grey = R"({"name": "grey")", glass = R"({"name": "glass", "type": "whitted", "transmission": 0.5, "eta": 1.5}, )";
    std::string text = read_file(scene);
    text.replace(text.find(grey), grey.size(), glass + grey);
    text.replace(text.find("[2, 3, 4]"), 9, "[0, 4, 1]");
    folder.write("scene.json", text);
    const Finished run = run_program({"inspect", scene, "16,12", "--size", "33x25", "--shadows", "filtered"});
    ASSERT_EQ(run.status, 0) << run.err;
    for (const char *part : {"wall.obj:5\n", "visible through 2 faces; adds ", "; lets through 0.5 each [0x1p-1]\n"})
        EXPECT_NE(run.out.find(part), std::string::npos) << part << " in\n" << run.out;
}

TEST(CliInspect, PixelsOfACropAreThoseOfThePicture) {
    const TemporaryFolder folder;
    const json whole = inspected(folder, {"8,6", "--json"}), crop = inspected(folder, {"8,6", "--json", "--crop", "7,5,10,9"});
    EXPECT_EQ(whole, crop);
    const Finished outside = inspect(folder, {"6,6", "--crop", "7,5,10,9"});
    EXPECT_EQ(outside.status, 2);
    EXPECT_NE(outside.err.find("6,6 is outside the picture, whose pixels are 7,5 to 9,8"), std::string::npos) << outside.err;
}

TEST(CliInspect, TextIsATreeAndThenEveryRay) {
    const TemporaryFolder folder;
    const Finished run = inspect(folder, {"8,6", "--sample", "3"});
    EXPECT_EQ(run.status, 0) << run.err;
    for (const char *part :
         {"pixel 8,6 of 16 x 12: 4 spp", "sample 3: ", "\n└─ 0 camera hits \"grey\", sphere 0: adds ", "\n   └─ 1 reflected meets nothing",
          "\nray 0: camera, depth 1, hits", "light 0, point", "\nray 1: reflected, depth 2, meets nothing", "\nsum of sample 3 ", " in 4 samples\n"})
        EXPECT_NE(run.out.find(part), std::string::npos) << part << " in\n" << run.out;
    const Finished brief = inspect(folder, {"8,6", "--brief"});
    EXPECT_EQ(brief.out.find("ray 0:"), std::string::npos) << brief.out;
    EXPECT_NE(brief.out.find("└─ 1 reflected"), std::string::npos) << brief.out;
}

TEST(CliInspect, RefusesSamplesThatTheCameraDoesNotSee) {
    const TemporaryFolder folder;
    EXPECT_EQ(inspect(folder, {"8,6", "--set", "camera.type=fisheye"}).status, 0);
    const Finished run = inspect(folder, {"0,0", "--set", "camera.type=fisheye"});
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.err, "brandung: sample 0 of pixel 0,0 lies outside of what the camera sees: it has no ray\n");
}
