/// Bad input: one line on standard error that names file, line and cause; exit 1 for input and device, 2 for usage; nothing left behind.
#include <gtest/gtest.h>
#include <unistd.h>

#include <random>

#include "tests/tools/program.h"
#include "tests/tools/scenes.h"

namespace {

/// What must hold of every failing run, and that its one line contains all of `parts`.
void expect_failure(const Finished &run, int status, const std::vector<std::string> &parts) {
    ASSERT_FALSE(run.timed_out) << "hangs; so far it wrote\n" << run.out << run.err;
    ASSERT_EQ(run.signal, 0) << "crashes\n" << run.err;
    EXPECT_EQ(run.status, status) << run.err;
    EXPECT_EQ(run.out, "");
    std::vector<std::string> errors;
    for (const std::string &line : lines_of(run.err))
        if (!line.starts_with("warning: ")) errors.push_back(line);
    ASSERT_EQ(errors.size(), 1u) << "one line, not\n" << run.err;
    EXPECT_TRUE(errors[0].starts_with("brandung: ")) << errors[0];
    EXPECT_TRUE(run.err.ends_with("\n"));
    for (const std::string &part : parts) EXPECT_NE(errors[0].find(part), std::string::npos) << "expected '" << part << "' in\n" << errors[0];
    for (const char c : errors[0]) EXPECT_TRUE(static_cast<unsigned char>(c) >= ' ' && c != '\x7f') << "control character in the message";
}

/// Renders `scene` to out.png in `folder` with these arguments more; afterwards the folder has only `before`.
void expect_render_fails(const TemporaryFolder &folder, const std::string &scene, const std::vector<std::string> &more, int status,
                         const std::vector<std::string> &parts, const RunOptions &options = {}) {
    const std::vector<std::string> before = folder.names();
    std::vector<std::string> arguments = {"render", scene, "--quiet"};
    if (std::find(more.begin(), more.end(), "-o") == more.end()) arguments.insert(arguments.end(), {"-o", folder.path("out.png")});
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_failure(run_program(arguments, options), status, parts);
    EXPECT_EQ(folder.names(), before) << "nothing is left behind";
}

}  // namespace

// ---- usage -----------------------------------------------------------------------------------------------------------------------------------

struct Usage {
    const char *name;
    std::vector<std::string> arguments;
    std::string says;
};
void PrintTo(const Usage &usage, std::ostream *out) { *out << usage.name; }

class BadUsage : public testing::TestWithParam<Usage> {};

TEST_P(BadUsage, Exits2WithOneLine) {
    const TemporaryFolder folder;
    std::vector<std::string> arguments = GetParam().arguments;
    for (std::string &argument : arguments) {
        if (argument == "SCENE") argument = folder.write("scene.json", native_scene());
        if (argument == "OUT") argument = folder.path("out.png");
        if (argument == "DETOUR") argument = folder.path("nowhere/.././out.png");
    }
    expect_failure(run_program(arguments), 2, {GetParam().says});
    for (const std::string &name : folder.names()) EXPECT_EQ(name, "scene.json");
}

INSTANTIATE_TEST_SUITE_P(Cli, BadUsage,
                         testing::Values(Usage{"NoSubcommand", {}, "subcommand"}, Usage{"UnknownSubcommand", {"draw"}, "draw"},
                                         Usage{"UnknownOption", {"render", "SCENE", "-o", "OUT", "--shiny"}, "--shiny"},
                                         Usage{"NoScene", {"render", "-o", "OUT"}, "scene"}, Usage{"NoOutput", {"render", "SCENE"}, "--output"},
                                         Usage{"OutputWithoutName", {"render", "SCENE", "-o"}, "--output"},
                                         Usage{"SppZero", {"render", "SCENE", "-o", "OUT", "--spp", "0"}, "1 to 16777216"},
                                         Usage{"SppNegative", {"render", "SCENE", "-o", "OUT", "--spp", "-1"}, "--spp"},
                                         Usage{"SppNoNumber", {"render", "SCENE", "-o", "OUT", "--spp", "many"}, "--spp"},
                                         Usage{"SppBeyondAnInteger", {"render", "SCENE", "-o", "OUT", "--spp", "9999999999999"}, "1 to 16777216"},
                                         Usage{"BatchZero", {"render", "SCENE", "-o", "OUT", "--batch", "0"}, "--batch"},
                                         Usage{"BatchHuge", {"render", "SCENE", "-o", "OUT", "--batch", "99999999999"}, "--batch"},
                                         Usage{"FromOfTwoNumbers", {"render", "SCENE", "-o", "OUT", "--from", "1,2"}, "--from"},
                                         Usage{"UpOfWords", {"render", "SCENE", "-o", "OUT", "--up", "0,0,z"}, "--up"},
                                         Usage{"AtBeyondTheLimit", {"render", "SCENE", "-o", "OUT", "--at", "0,0,1e16"}, "--at"},
                                         Usage{"FovOf180", {"render", "SCENE", "-o", "OUT", "--fov", "180"}, "--fov"},
                                         Usage{"SizeWithoutCross", {"render", "SCENE", "-o", "OUT", "--size", "100"}, "--size"},
                                         Usage{"DepthZero", {"render", "SCENE", "-o", "OUT", "--max-depth", "0"}, "1 to 1000"},
                                         Usage{"SameOutputTwice", {"render", "SCENE", "-o", "OUT", "-o", "OUT"}, "--output"},
                                         Usage{"StatisticsInTheOutput", {"render", "SCENE", "-o", "OUT", "--stats", "OUT"}, "--stats"},
                                         Usage{
                                             "StatisticsInTheOutputByAnotherName", {"render", "SCENE", "-o", "OUT", "--stats", "DETOUR"}, "--stats"},
                                         Usage{"StatisticsInTheScene", {"render", "SCENE", "-o", "OUT", "--stats", "SCENE"}, "--stats"},
                                         Usage{"SeedNegative", {"render", "SCENE", "-o", "OUT", "--seed", "-1"}, "0 to 4294967295"},
                                         Usage{"SeedHuge", {"render", "SCENE", "-o", "OUT", "--seed", "5000000000"}, "0 to 4294967295"},
                                         Usage{"ThreadsNegative", {"render", "SCENE", "-o", "OUT", "--threads", "-2"}, "0 to 65536"}),
                         [](const auto &info) { return info.param.name; });

// ---- settings --------------------------------------------------------------------------------------------------------------------------------

struct Setting {
    const char *name;
    std::vector<std::string> arguments;
    std::vector<std::string> says;
};
void PrintTo(const Setting &setting, std::ostream *out) { *out << setting.name; }

class BadSetting : public testing::TestWithParam<Setting> {};

/// Exit 1 or 2: a refused value is the input's or the usage's fault.
void expect_refused(const std::string &extension, const std::string &text, const Setting &setting) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene" + extension, text);
    std::vector<std::string> arguments = {"render", scene, "-o", folder.path("out.png"), "--quiet"};
    arguments.insert(arguments.end(), setting.arguments.begin(), setting.arguments.end());
    const Finished run = run_program(arguments);
    expect_failure(run, run.status == 2 ? 2 : 1, setting.says);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"scene" + extension})) << "nothing is left behind";
}

TEST_P(BadSetting, IsRefusedForNativeScenes) { expect_refused(".json", native_scene(), GetParam()); }
TEST_P(BadSetting, IsRefusedForNffScenes) { expect_refused(".nff", nff_scene(), GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Cli, BadSetting,
    testing::Values(
        Setting{"ResolutionZero", {"--size", "0x0"}, {"width", "0"}}, Setting{"HeightZero", {"--size", "10x0"}, {"height"}},
        Setting{"ResolutionNegative", {"--size", "-5x5"}, {"-5"}}, Setting{"ResolutionOfWords", {"--size", "axb"}, {"width", "a"}},
        Setting{"ResolutionWithoutHeight", {"--size", "10x"}, {"height"}}, Setting{"ResolutionOfThree", {"--size", "2x3x4"}, {"height", "3x4"}},
        Setting{"ResolutionBeyondTheLimit", {"--size", "70000x70000"}, {"width", "70000"}},
        Setting{
            "UnknownIntegrator", {"--integrator", "magic"}, {": /integrator/type (set on the command line): there is no \"magic\", only whitted"}},
        Setting{"IntegratorOfTwoLines", {"--integrator", "a\nb"}, {"there is no \"a?b\""}},
        Setting{"UnknownAccelerator", {"--accelerator", "magic"}, {"magic", "wide_bvh"}},
        Setting{"UnknownPixel", {"--pixel", "edge"}, {"edge", "corner"}}, Setting{"UnknownCamera", {"--camera", "drone"}, {"drone"}},
        Setting{"UnknownDevice", {"--device", "abacus"}, {"abacus"}},
        Setting{"CornerWithManySamples",
                {"--pixel", "corner", "--spp", "4"},
                {": /film/pixel (set on the command line): 'corner' takes one sample per pixel, not 4"}},
        Setting{"DepthBeyondTheLimit", {"--max-depth", "100000"}, {"--max-depth", "1 to 1000"}},
        Setting{"SetWithoutValue", {"--set", "film.spp"}, {"film.spp", "KEY=VALUE"}}, Setting{"SetWithoutKey", {"--set", "=1"}, {"KEY=VALUE"}},
        Setting{"SetOfUnknownKey", {"--set", "film.colour=1"}, {"colour"}}, Setting{"SetOfUnknownSection", {"--set", "magic=1"}, {"magic"}},
        Setting{"SetToWrongType", {"--set", "film.spp=lots"}, {"spp", "lots"}}, Setting{"SetToZero", {"--set", "film.spp=0"}, {"spp", "0"}},
        Setting{"SetToAFraction", {"--set", "film.spp=1.5"}, {"spp", "1.5"}},
        Setting{"ExposureBeyondFloats", {"--set", "film.exposure=1000"}, {"exposure", "1000"}},
        Setting{"SetToInfinity", {"--set", "film.exposure=1e999"}, {"exposure"}}, Setting{"SetThroughANumber", {"--set", "film.spp.more=1"}, {"spp"}},
        Setting{"ThresholdNegative", {"--set", "integrator.threshold=-1"}, {"threshold", "-1"}}),
    [](const auto &info) { return info.param.name; });

TEST(BadResolution, BeyondMemoryIsRefusedWithTheSizesBeforeRendering) {
    const TemporaryFolder folder;
    // 65535² pixels of 104 bytes in the film and 12 in the picture: 464 GiB.
    expect_render_fails(folder, folder.write("scene.json", native_scene()), {"--size", "65535x65535"}, 1, {"65535", "MiB"});
}

TEST(BadBatch, WavesBeyondMemoryAreRefusedWithTheSizesBeforeRendering) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.nff", nff_scene("f 1 1 1 1 1 1 0 1\ns 0 0 0 1\n"));
    // 16 M mirrored rays of each of 1000 generations: nearly a TiB.
    expect_render_fails(folder, scene, {"--batch", "16777216", "--max-depth", "1000"}, 1, {scene, "MiB", "waves"});
}

// ---- scene files -----------------------------------------------------------------------------------------------------------------------------

struct SceneText {
    const char *name;
    std::string file, text;
    std::vector<std::string> says;  ///< beside the file's name
};
void PrintTo(const SceneText &scene, std::ostream *out) { *out << scene.name; }

class BadScene : public testing::TestWithParam<SceneText> {};

TEST_P(BadScene, Exits1NamingFileAndCause) {
    const TemporaryFolder folder;
    std::vector<std::string> says = GetParam().says;
    says.push_back(GetParam().file);
    const std::string scene = folder.write(GetParam().file, GetParam().text);
    expect_render_fails(folder, scene, {}, 1, says);
}

namespace {

/// A native scene whose one object is this; it is on line 8.
SceneText with_object(const char *name, const std::string &object, std::vector<std::string> says) {
    says.push_back("scene.json:8:");
    return {name, "scene.json", native_scene(object), says};
}

SceneText with_nff(const char *name, const std::string &objects, const std::vector<std::string> &says) {
    return {name, "scene.nff", nff_scene(objects), says};
}

SceneText with_more(const char *name, const std::string &more, const std::vector<std::string> &says) {
    return {name, "scene.json", native_scene(R"({"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1})", more), says};
}

std::vector<SceneText> bad_scenes() {
    const std::string sphere = R"({"type": "sphere", "material": "grey", "center": [0, 0, 0], )";
    const std::string mesh = R"({"type": "triangle_mesh", "material": "grey", "positions": [[0,0,0],[1,0,0],[0,1,0]], )";
    const std::string json = native_scene();
    return {
        {"EmptyNative", "scene.json", "", {"empty"}},
        {"EmptyNff", "scene.nff", "", {"empty"}},
        {"OnlyBlanks", "scene.nff", " \n\n# nothing\n", {"viewpoint"}},
        {"UnknownExtension", "scene.blend", "BLENDER", {".blend", ".json", ".obj"}},
        {"NoExtension", "scene", json, {".json"}},
        {"TruncatedNative", "scene.json", json.substr(0, json.size() / 2), {"scene.json:"}},
        {"NativeWithoutEnd", "scene.json", json.substr(0, json.size() - 3), {"scene.json:"}},
        {"TruncatedNff", "scene.nff", nff_scene("s 0 0"), {"scene.nff:10:", "end of the file"}},
        {"NativeIsNoObject", "scene.json", "[1, 2]", {"object"}},
        {"DeepNesting", "scene.json", std::string(200000, '['), {"nested"}},
        {"TrailingText", "scene.json", json + "more", {"scene.json:"}},
        {"DuplicateKey", "scene.json", "{\"ambient\": 1,\n\"ambient\": 2}", {"scene.json:2:", "ambient"}},
        {"NativeIsNff", "scene.json", nff_scene(), {"scene.json:1:"}},
        {"NffIsNative", "scene.nff", json, {"scene.nff:1:"}},
        {"NulBytes", "scene.nff", std::string(1000, '\0'), {"scene.nff:1:"}},
        {"NulBytesInNative", "scene.json", std::string(1000, '\0'), {"scene.json:1:"}},
        with_object("UnknownKey", sphere + R"("radius": 1, "colour": 3})", {"colour"}),
        with_object("MisspeltKey", sphere + R"("raduis": 1})", {"radius"}),
        with_object("UnknownObject", R"({"type": "teapot", "material": "grey"})", {"teapot", "sphere"}),
        with_object("UnknownMaterial", R"({"type": "sphere", "material": "gold", "center": [0,0,0], "radius": 1})", {"gold", "grey"}),
        with_object("NoRadius", R"({"type": "sphere", "material": "grey", "center": [0, 0, 0]})", {"radius"}),
        with_object("NegativeRadius", sphere + R"("radius": -1})", {"/objects/0/radius", "-1"}),
        with_object("NegativeCylinder", R"({"type": "cylinder", "material": "grey", "base": [0,0,0], "apex": [0,1,0], "radius": -1})",
                    {"radius", "-1"}),
        with_object("RadiusIsText", sphere + R"("radius": "1"})", {"radius", "number"}),
        with_object("NumberBeyondFloat", sphere + R"("radius": 1e39})", {"radius", "float"}),
        with_object("NumberBeyondSquares", sphere + R"("radius": 1e30})", {"radius", "1e15"}),
        with_object("CenterOfTwo", R"({"type": "sphere", "material": "grey", "center": [0, 0], "radius": 1})", {"center", "3"}),
        with_object("IndexOutOfRange", mesh + R"("indices": [0, 1, 3]})", {"/objects/0/indices/2", "got 3"}),
        with_object("IndexNegative", mesh + R"("indices": [0, 1, -1]})", {"indices", "-1"}),
        with_object("IndexFractional", mesh + R"("indices": [0, 1, 1.5]})", {"indices", "1.5"}),
        with_object("IndexHuge", mesh + R"("indices": [0, 1, 4294967296]})", {"indices", "4294967296"}),
        with_object("IndicesNotInThrees", mesh + R"("indices": [0, 1, 2, 0]})", {"indices", "4"}),
        with_object("NoVertices", R"({"type": "triangle_mesh", "material": "grey", "positions": [], "indices": [0, 1, 2]})", {"positions"}),
        with_object("TooFewNormals", mesh + R"("normals": [[0,0,1]], "indices": [0, 1, 2]})", {"normals", "1"}),
        with_object("NormalOfZero", mesh + R"("normals": [[0,0,1],[0,0,0],[0,0,1]], "indices": [0, 1, 2]})", {"normals", "1"}),
        with_object("PolygonOfTwo", R"({"type": "polygon", "material": "grey", "vertices": [[0,0,0],[1,0,0]]})", {"vertices", "2"}),
        {"NotANumberNative", "scene.json", native_scene(sphere + R"("radius": NaN})"), {"scene.json:8:"}},
        {"InfiniteNative", "scene.json", native_scene(sphere + R"("radius": Infinity})"), {"scene.json:8:"}},
        {"OverflowNative", "scene.json", native_scene(sphere + R"("radius": 1e999})"), {"scene.json:8:"}},
        with_more("UnknownSection", R"("magic": 1,)", {"magic"}),
        with_more("UnknownIntegrator",
                  "\n"
                  R"("integrator": {"type": "path"},)",
                  {"scene.json:7: /integrator/type: there is no \"path\", only whitted"}),
        with_more("TwoKindsOfCameras", R"("cameras": [],)", {"has both"}),
        {"NoCamera", "scene.json", R"({"objects": []})", {"camera"}},
        {"ViewWithoutDirection", "scene.json", R"({"camera": {"from": [1,2,3], "at": [1,2,3]}})", {"at", "from"}},
        {"UpAlongTheView", "scene.json", R"({"camera": {"from": [0,0,3], "at": [0,0,0], "up": [0,0,1]}})", {"up", "parallel"}},
        {"FieldOfViewOf180", "scene.json", R"({"camera": {"from": [0,0,3], "at": [0,0,0], "fov": 180}})", {"fov", "180"}},
        {"ResolutionOfZero", "scene.json", R"({"film": {"width": 0}, "camera": {"from": [0,0,3], "at": [0,0,0]}})", {"width", "0"}},
        {"NegativeAlbedo",
         "scene.json",
         R"({"materials": [{"name": "a", "type": "whitted", "diffuse": -0.5}], "camera": {"from": [0,0,3], "at": [0,0,0]}})",
         {"diffuse", "-0.5"}},
        {"MirrorOfMoreThanOne",
         "scene.json",
         R"({"materials": [{"name": "a", "type": "whitted", "reflection": 1.5}], "camera": {"from": [0,0,3], "at": [0,0,0]}})",
         {"reflection"}},
        {"EtaOfZero",
         "scene.json",
         R"({"materials": [{"name": "a", "type": "whitted", "eta": 0}], "camera": {"from": [0,0,3], "at": [0,0,0]}})",
         {"eta", "0"}},
        {"TwoMaterialsOfOneName",
         "scene.json",
         R"({"materials": [{"name": "a", "type": "whitted"}, {"name": "a", "type": "whitted"}], "camera": {"from": [0,0,3], "at": [0,0,0]}})",
         {"a"}},
        {"LightWithoutAttenuation",
         "scene.json",
         R"({"lights": [{"type": "point", "position": [0,0,0], "intensity": 1, "attenuation": [0,0,0]}], "camera": {"from": [0,0,3], "at": [0,0,0]}})",
         {"attenuation"}},
        {"DirectionOfZero",
         "scene.json",
         R"({"lights": [{"type": "directional", "direction": [0,0,0], "irradiance": 1}], "camera": {"from": [0,0,3], "at": [0,0,0]}})",
         {"direction"}},
        with_nff("NotANumber", "s 0 0 0 nan\n", {"scene.nff:10:", "radius", "nan"}),
        with_nff("Infinite", "s 0 inf 0 1\n", {"scene.nff:10:", "inf"}),
        with_nff("Overflow", "s 0 1e999 0 1\n", {"scene.nff:10:", "1e999"}),
        with_nff("BeyondSquares", "s 0 1e20 0 1\n", {"scene.nff:10:", "1e+15"}),
        with_nff("UnknownEntity", "s 0 0 0 1\nblob 1 2 3\n", {"scene.nff:11:", "blob"}),
        with_nff("TextForANumber", "s 0 0 zero 1\n", {"scene.nff:10:", "zero"}),
        with_nff("HexForANumber", "s 0 0 0x10 1\n", {"scene.nff:10:", "0x10"}),
        with_nff("PolygonOfNone", "p 0\n", {"scene.nff:10:", "3"}),
        with_nff("PolygonOfMinusThree", "p -3\n0 0 0\n", {"scene.nff:10:", "-3"}),
        with_nff("PolygonCutShort", "p 4\n0 0 0\n1 0 0\n1 1 0\n", {"scene.nff:", "4", "3"}),
        with_nff("PolygonOfMoreThanMemory", "p 99999999999999\n0 0 0\n", {"scene.nff:", "99999999999999"}),
        with_nff("PolygonOfMoreThanAnInteger", "p 99999999999999999999\n0 0 0\n", {"scene.nff:10:"}),
        with_nff("RadiiOfBothSigns", "c 0 0 0 1\n0 1 0 -1\n", {"scene.nff:11:", "sign"}),
        with_nff("NegativeShine", "f 1 1 1 1 0 -5 0 1\n", {"scene.nff:10:", "shine"}),
        with_nff("GlassOfIndexZero", "f 1 1 1 1 0 5 0.5 0\n", {"scene.nff:10:", "index of refraction"}),
        with_nff("SecondViewpoint", "v\nfrom 0 0 1\nat 0 0 0\nup 0 1 0\nangle 40\nresolution 1 1\n", {"scene.nff:10:", "line 2"}),
        {"NffResolutionOfZero", "scene.nff", "v\nfrom 0 0 1\nat 0 0 0\nup 0 1 0\nangle 40\nresolution 0 1\n", {"scene.nff:6:", "resolution"}},
        {"NffResolutionTooBig", "scene.nff", "v\nfrom 0 0 1\nat 0 0 0\nup 0 1 0\nangle 40\nresolution 70000 1\n", {"scene.nff:6:", "70000"}},
        {"NffWithoutAngle", "scene.nff", "v\nfrom 0 0 1\nat 0 0 0\nup 0 1 0\nresolution 9 9\n", {"scene.nff:1:", "angle"}},
        {"NffAngleOf180", "scene.nff", "v\nfrom 0 0 1\nat 0 0 0\nup 0 1 0\nangle 180\nresolution 9 9\n", {"scene.nff:5:", "180"}},
        {"NffViewWithoutDirection", "scene.nff", "v\nfrom 0 0 1\nat 0 0 1\nup 0 1 0\nangle 40\nresolution 9 9\n", {"scene.nff:1:", "from"}},
    };
}

}  // namespace

INSTANTIATE_TEST_SUITE_P(Cli, BadScene, testing::ValuesIn(bad_scenes()), [](const auto &info) { return info.param.name; });

TEST(BadFile, MissingSceneIsNamed) {
    const TemporaryFolder folder;
    expect_render_fails(folder, folder.path("nowhere.json"), {}, 1, {folder.path("nowhere.json"), "no such file"});
    expect_failure(run_program({"info", folder.path("nowhere.nff")}), 1, {"nowhere.nff", "no such file"});
}

TEST(BadFile, AFolderIsNoScene) {
    const TemporaryFolder folder;
    for (const char *name : {"scene.json", "scene.nff"}) {
        std::filesystem::create_directory(folder.path(name));
        expect_render_fails(folder, folder.path(name), {}, 1, {folder.path(name), "folder"});
    }
}

TEST(BadFile, SceneWithoutPermission) {
    if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    std::filesystem::permissions(scene, std::filesystem::perms::none);
    expect_render_fails(folder, scene, {}, 1, {scene});
}

/// Files of random bytes and good ones with a few bytes changed: refused in one line, or read; nothing else. The readers' own tests try more.
TEST(BadFile, RandomBytesNeverCrash) {
    std::mt19937 random(1);
    const auto byte = [&] { return static_cast<char>(random() & 0xff); };
    const TemporaryFolder folder;
    for (int i = 0; i < 20; ++i) {
        for (const bool native : {true, false}) {
            std::string text = native ? native_scene() : nff_scene("s 0 0 0 1\np 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\nc 0 0 0 1\n0 2 0 0\n");
            if (i < 10) {
                text.resize(random() % 2000 + 1);
                for (char &c : text) c = byte();
            } else {
                for (int change = 0; change < 3; ++change) text[random() % text.size()] = byte();
            }
            const std::string scene = folder.write(native ? "scene.json" : "scene.nff", text);
            // `info` reads the whole scene and builds its hierarchy; a changed byte may ask for much, but not for long.
            const Finished run = run_program({"info", scene});
            ASSERT_FALSE(run.timed_out) << text;
            ASSERT_EQ(run.signal, 0) << text;
            if (run.status != 0) expect_failure(run, 1, {scene});
        }
    }
}

TEST(BadFile, TrianglesWithoutAreaAreCountedNotRendered) {
    const TemporaryFolder folder;
    const std::string scene =
        folder.write("scene.json", native_scene(R"({"type": "triangle_mesh", "material": "grey", "positions": [[0,0,0],[1,0,0],[0,1,0],[2,0,0]],
        "indices": [0, 1, 2, 0, 1, 3, 1, 1, 2]})"));
    const Finished run = run_program({"render", scene, "-o", folder.path("out.png"), "--quiet"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "warning: triangle without area: left out (2 times)\n");
}

TEST(BadFile, ASceneWithoutObjectsIsBackground) {
    const TemporaryFolder folder;
    const std::string scene =
        folder.write("scene.json", R"({"film": {"width": 8, "height": 8}, "background": 1, "camera": {"from": [0,0,3], "at": [0,0,0]}})");
    const Finished run = run_program({"render", scene, "-o", folder.path("out.png"), "--quiet"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "warning: the scene has no objects\n");
}

// ---- outputs ---------------------------------------------------------------------------------------------------------------------------------

TEST(BadOutput, UnknownPictureType) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    expect_render_fails(folder, scene, {"-o", folder.path("out.xyz")}, 1, {folder.path("out.xyz"), "xyz"});
    expect_render_fails(folder, scene, {"-o", folder.path("out")}, 1, {folder.path("out") + ": cannot write a picture: the name has no extension"});
    expect_render_fails(folder, scene, {"-o", "/tmp"}, 1, {"/tmp: cannot write there: it is a folder"});
    for (const char *name : {"out.zfile", "out.null", "out.term"})
        expect_render_fails(folder, scene, {"-o", folder.path(name)}, 1, {folder.path(name), "cannot write"});
    expect_render_fails(folder, scene, {"-o", folder.path("good.png"), "-o", folder.path("out.xyz")}, 1, {folder.path("out.xyz")});
}

TEST(BadOutput, FolderThatIsNotThere) {
    const TemporaryFolder folder;
    expect_render_fails(folder, folder.write("scene.json", native_scene()), {"-o", folder.path("nowhere/out.png")}, 1,
                        {folder.path("nowhere/out.png"), "folder"});
}

TEST(BadOutput, NamesThatAreTooLong) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene()), name = folder.path(std::string(300, 'x'));
    expect_render_fails(folder, scene, {"-o", name + ".png"}, 1, {name + ".png: cannot write there: File name too long"});
    expect_render_fails(folder, scene, {"--stats", name}, 1, {name + ": cannot write there: File name too long"});
    expect_render_fails(folder, name + ".json", {}, 1, {name + ".json: cannot be read: File name too long"});
}

TEST(BadOutput, StandardOutputThatTakesNothing) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    RunOptions options;
    options.out_file = "/dev/full";
    for (const std::vector<std::string> &arguments :
         {std::vector<std::string>{"--help"}, {"--version"}, {"devices"}, {"info", scene}, {"info", scene, "--json"}})
        expect_failure(run_program(arguments, options), 1, {"standard output"});
    expect_render_fails(folder, scene, {"--explain"}, 1, {"standard output"}, options);
}

TEST(BadOutput, NameOfAFolder) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("out.png"));
    expect_render_fails(folder, folder.write("scene.json", native_scene()), {}, 1, {folder.path("out.png"), "folder"});
}

TEST(BadOutput, FolderWithoutPermission) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    // Not even root can make files in /proc.
    expect_render_fails(folder, scene, {"-o", "/proc/out.png"}, 1, {"/proc/out.png"});
}

/// Not after a render of hours.
TEST(BadOutput, StatisticsThatCannotBeWrittenAreRefusedBeforeRendering) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    for (const std::string &stats : {folder.path("nowhere/stats.json"), std::string("/proc/stats.json"), folder.path("")})
        expect_render_fails(folder, scene, {"--stats", stats}, 1, {stats});
}

namespace {

/// Files may have 1 MiB, as on a full disk; PoCL needs more than half of that to start kernels that it has built before.
RunOptions full_disk() {
    RunOptions options;
    options.largest_file = 1 << 20;
    return options;
}

/// A picture that none of the formats below packs into 1 MiB.
const std::vector<std::string> big = {"--size", "1200x1200", "--set", "camera.fov=25"};

}  // namespace

TEST(BadOutput, FullDiskLeavesTheOldPictureAndNoHalfOne) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    for (const char *name : {"out.exr", "out.tif", "out.hdr"}) {
        SCOPED_TRACE(name);
        std::vector<std::string> arguments = big;
        arguments.insert(arguments.end(), {"-o", folder.path(name)});
        std::vector<std::string> all = {"render", scene, "--quiet"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        ASSERT_EQ(run_program(all).status, 0) << "fills the kernel cache";
        const std::string old = read_file(folder.path(name));
        ASSERT_GT(old.size(), full_disk().largest_file) << "the test tests something";
        expect_render_fails(folder, scene, arguments, 1, {folder.path(name)}, full_disk());
        EXPECT_EQ(read_file(folder.path(name)) == old, true);
    }
}

// ---- device ----------------------------------------------------------------------------------------------------------------------------------

TEST(BadDevice, NoneAtAllNamesThePackageToInstall) {
    const TemporaryFolder folder, no_drivers;
    RunOptions options;
    options.environment["OCL_ICD_VENDORS"] = no_drivers.path("");
    expect_failure(run_program({"devices"}, options), 1, {"pocl-opencl-icd"});
    expect_render_fails(folder, folder.write("scene.json", native_scene()), {}, 1, {"pocl-opencl-icd"}, options);
}

TEST(BadDevice, UnknownOneIsAnsweredWithThoseThatThereAre) {
    const TemporaryFolder folder;
    expect_render_fails(folder, folder.write("scene.json", native_scene()), {"--device", "abacus"}, 1, {"abacus", "pthread"});
}

TEST(BadDevice, AFaultyDriverDoesNotKeepTheOtherDevicesFromBeingUsed) {
    const TemporaryFolder folder, drivers;
    for (const auto &driver : std::filesystem::directory_iterator("/etc/OpenCL/vendors"))
        drivers.write(driver.path().filename().string(), read_file(driver.path().string()));
    drivers.write("faulty.icd", FAULTY_DRIVER "\n");
    RunOptions options;
    options.environment["OCL_ICD_VENDORS"] = drivers.path("");
    const Finished listed = run_program({"devices"}, options);
    EXPECT_EQ(listed.status, 0) << listed.err;
    EXPECT_NE(listed.out.find("  broken accelerator |"), std::string::npos) << listed.out;
    EXPECT_NE(listed.out.find("cannot be used: it cannot be described: clGetDeviceInfo failed with CL_OUT_OF_RESOURCES"), std::string::npos)
        << listed.out;
    const std::string scene = folder.write("scene.json", native_scene());
    EXPECT_EQ(run_program({"info", scene}, options).status, 0);
    expect_render_fails(folder, scene, {"--device", "broken"}, 1, {"'broken accelerator' cannot be described"}, options);
}

TEST(BadDevice, KernelFolderThatIsNotThere) {
    const TemporaryFolder folder;
    RunOptions options;
    options.environment["KERNEL_DIR"] = folder.path("nowhere");
    expect_render_fails(folder, folder.write("scene.json", native_scene()), {}, 1, {" in KERNEL_DIR=" + folder.path("nowhere")}, options);
}

/// Where PoCL finds no device without its cache, and where it finds one but cannot build.
TEST(BadDevice, KernelCacheThatCannotBeWrittenIsNamed) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene()), file = folder.write("file", "");
    RunOptions options;
    options.environment["POCL_CACHE_DIR"] = file + "/cache";
    expect_render_fails(folder, scene, {}, 1, {"PoCL cannot write its kernel cache " + file + "/cache (Not a directory)"}, options);
    options.environment["POCL_CACHE_DIR"] = "/proc";
    expect_render_fails(folder, scene, {}, 1, {"cannot be built", "PoCL cannot write its kernel cache /proc ("}, options);
}

TEST(CliBadInput, BackgroundsThatAreNeitherColourNorPicture) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    for (const char *background : {"1,2", "1,2,3,4", "nan", "1,inf,0", "#12345", "#1234567", "#12345g"})
        expect_render_fails(folder, scene, {"--background", background}, 2, {"--background", background});
    expect_render_fails(folder, scene, {"--background", "-1"}, 1, {"/background", "must be not negative"});
    expect_render_fails(folder, scene, {"--background", folder.path("none.hdr")}, 1, {"/background/image", "none.hdr: no such file"});
    expect_render_fails(folder, scene, {"--background", scene}, 1, {"/background/image", "cannot read the picture"});
}

TEST(CliBadInput, PicturesOfMaterials) {
    const TemporaryFolder folder;
    const std::string empty = folder.write("empty.png", "");
    const std::string scene = folder.write("scene.json", R"({"camera": {"from": [0, 0, 4], "at": [0, 0, 0]},
        "materials": [{"name": "a", "type": "whitted",
            "diffuse": {"texture": "empty.png"}}]})");
    expect_render_fails(folder, scene, {}, 1, {"scene.json:3: /materials/0/diffuse/texture: ", "empty.png: is empty"});
    expect_render_fails(folder, scene, {"--set", "materials.0.diffuse.wrap=mirror"}, 1, {"/materials/0/diffuse/wrap", "one of repeat, clamp"});
}
