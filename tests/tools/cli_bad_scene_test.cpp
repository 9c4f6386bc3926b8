/// Bad scene files: one line on standard error that names file, line and cause; exit 1, nothing left behind.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <random>

#include "tests/tools/bad_input.h"
#include "tests/tools/scenes.h"

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
        with_object("DiskWithoutNormal", R"({"type": "disk", "material": "grey", "center": [0,0,0], "normal": [0,0,0], "radius": 1})",
                    {"/objects/0/normal", "zero"}),
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
                  R"("integrator": {"type": "radiosity"},)",
                  {"scene.json:7: /integrator/type: there is no \"radiosity\", only whitted, path, distributed"}),
        with_more("BundleOfHalves",
                  "\n"
                  R"("integrator": {"type": "distributed", "bundles": {"diffuse": 1.5}},)",
                  {"scene.json:7: /integrator/bundles/diffuse: must be", "1.5"}),
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
    EXPECT_EQ(run.err, "warning: triangle without area: left out (2 times, first at " + scene + ":8: /objects/0)\n");
}

TEST(BadFile, ASceneWithoutObjectsIsBackground) {
    const TemporaryFolder folder;
    const std::string scene =
        folder.write("scene.json", R"({"film": {"width": 8, "height": 8}, "background": 1, "camera": {"from": [0,0,3], "at": [0,0,0]}})");
    const Finished run = run_program({"render", scene, "-o", folder.path("out.png"), "--quiet"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "warning: the scene has no objects (" + scene + ")\n");
}
