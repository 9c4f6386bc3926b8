/// Wrong usage and bad settings: one line on standard error that names the cause; exit 2 for usage, 1 for what scenes cannot be set to; nothing left
/// behind.
#include <gtest/gtest.h>

#include "tests/tools/bad_input.h"
#include "tests/tools/scenes.h"

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

INSTANTIATE_TEST_SUITE_P(
    Cli, BadUsage,
    testing::Values(
        Usage{"NoSubcommand", {}, "subcommand"}, Usage{"UnknownSubcommand", {"draw"}, "draw"},
        Usage{"UnknownOption", {"render", "SCENE", "-o", "OUT", "--shiny"}, "--shiny"}, Usage{"NoScene", {"render", "-o", "OUT"}, "scene"},
        Usage{"NoOutput", {"render", "SCENE"}, "--output"}, Usage{"OutputWithoutName", {"render", "SCENE", "-o"}, "--output"},
        Usage{"SppZero", {"render", "SCENE", "-o", "OUT", "--spp", "0"}, "1 to 16777216"},
        Usage{"SppNegative", {"render", "SCENE", "-o", "OUT", "--spp", "-1"}, "--spp"},
        Usage{"SppNoNumber", {"render", "SCENE", "-o", "OUT", "--spp", "many"}, "--spp"},
        Usage{"SppBeyondAnInteger", {"render", "SCENE", "-o", "OUT", "--spp", "9999999999999"}, "1 to 16777216"},
        Usage{"BatchZero", {"render", "SCENE", "-o", "OUT", "--batch", "0"}, "--batch"},
        Usage{"BatchHuge", {"render", "SCENE", "-o", "OUT", "--batch", "99999999999"}, "--batch"},
        Usage{"FromOfTwoNumbers", {"render", "SCENE", "-o", "OUT", "--from", "1,2"}, "--from"},
        Usage{"UpOfWords", {"render", "SCENE", "-o", "OUT", "--up", "0,0,z"}, "--up"},
        Usage{"AtBeyondTheLimit", {"render", "SCENE", "-o", "OUT", "--at", "0,0,1e16"}, "--at"},
        Usage{"FovBeyondAnyCamera", {"render", "SCENE", "-o", "OUT", "--fov", "361"}, "--fov"},
        Usage{"FovOfNoNumber", {"render", "SCENE", "-o", "OUT", "--fov", "nan"}, "above 0 and at most 360 degrees, got 'nan'"},
        Usage{"SaveEveryNoNumber",
              {"render", "SCENE", "-o", "OUT", "--save-every", "nan"},
              "--save-every: must be a finite number of seconds above 0, got 'nan'"},
        Usage{"SaveEveryInfinity", {"render", "SCENE", "-o", "OUT", "--save-every", "inf"}, "seconds above 0, got 'inf'"},
        Usage{"SaveEveryZero", {"render", "SCENE", "-o", "OUT", "--save-every", "0"}, "seconds above 0, got '0'"},
        Usage{"SizeWithoutCross", {"render", "SCENE", "-o", "OUT", "--size", "100"}, "--size"},
        Usage{"DepthZero", {"render", "SCENE", "-o", "OUT", "--max-depth", "0"}, "1 to 1000"},
        Usage{"SameOutputTwice", {"render", "SCENE", "-o", "OUT", "-o", "OUT"}, "--output"},
        Usage{"StatisticsInTheOutput", {"render", "SCENE", "-o", "OUT", "--stats", "OUT"}, "--stats"},
        Usage{"StatisticsInTheOutputByAnotherName", {"render", "SCENE", "-o", "OUT", "--stats", "DETOUR"}, "--stats"},
        Usage{"StatisticsInTheScene", {"render", "SCENE", "-o", "OUT", "--stats", "SCENE"}, "--stats"},
        Usage{"SeedNegative", {"render", "SCENE", "-o", "OUT", "--seed", "-1"}, "0 to 4294967295"},
        Usage{"SeedHuge", {"render", "SCENE", "-o", "OUT", "--seed", "5000000000"}, "0 to 4294967295"},
        Usage{"ThreadsNegative", {"render", "SCENE", "-o", "OUT", "--threads", "-2"}, "0 to 65536"},
        Usage{"InspectNoPixel", {"inspect", "SCENE"}, "PIXEL is required"},
        Usage{"InspectNoComma", {"inspect", "SCENE", "8"}, "expected X,Y from the top left, got '8'"},
        Usage{"InspectEmptyPixel", {"inspect", "SCENE", ""}, "expected X,Y"}, Usage{"InspectNoNumbers", {"inspect", "SCENE", "a,b"}, "got 'a,b'"},
        Usage{"InspectFraction", {"inspect", "SCENE", "1.5,2"}, "got '1.5,2'"}, Usage{"InspectThree", {"inspect", "SCENE", "1,2,3"}, "got '1,2,3'"},
        Usage{"InspectHuge", {"inspect", "SCENE", "99999999999,1"}, "got '99999999999,1'"},
        Usage{"InspectTooFarRight", {"inspect", "SCENE", "16,0", "--size", "16x12"}, "16,0 is outside the picture, whose pixels are 0,0 to 15,11"},
        Usage{"InspectTooFarDown", {"inspect", "SCENE", "0,12", "--size", "16x12"}, "0,12 is outside"},
        Usage{"InspectSampleBeyondTheLast",
              {"inspect", "SCENE", "0,0", "--spp", "4", "--sample", "4"},
              "4 is beyond the last sample, 3: film.spp is 4"},
        Usage{"InspectSampleOfWords", {"inspect", "SCENE", "0,0", "--sample", "first"}, "expected a number or 'all', got 'first'"}),
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
TEST(BadSettingOfACamera, AnAngleIsRefusedWhereThereIsNone) {
    expect_refused(".json", native_scene(),
                   {"",
                    {"--fov", "30", "--set", R"(camera={"type":"orthographic","from":[0,0,4],"at":[0,0,0],"height":2})"},
                    {": camera \"camera\" is orthographic and has no \"fov\""}});
}

TEST_P(BadSetting, IsRefusedForNffScenes) { expect_refused(".nff", nff_scene(), GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Cli, BadSetting,
    testing::Values(
        Setting{"ResolutionZero", {"--size", "0x0"}, {"width", "0"}}, Setting{"HeightZero", {"--size", "10x0"}, {"height"}},
        Setting{"ResolutionNegative", {"--size", "-5x5"}, {"-5"}}, Setting{"ResolutionOfWords", {"--size", "axb"}, {"width", "a"}},
        Setting{"ResolutionWithoutHeight", {"--size", "10x"}, {"height"}}, Setting{"ResolutionOfThree", {"--size", "2x3x4"}, {"height", "3x4"}},
        Setting{"ResolutionBeyondTheLimit", {"--size", "70000x70000"}, {"width", "70000"}},
        Setting{"UnknownIntegrator",
                {"--integrator", "magic"},
                {": /integrator/type (set on the command line): there is no \"magic\", only whitted, path, distributed"}},
        Setting{"BundleOfNone",
                {"--bundles", "light=0"},
                {": /integrator/bundles/light (set on the command line): must be a whole number from 1 to 1024, got 0"}},
        Setting{"BundleBeyondTheLimit", {"--bundles", "light=4,glossy=1025"}, {": /integrator/bundles/glossy", "from 1 to 1024, got 1025"}},
        Setting{"BundleOfUnknownKind", {"--bundles", "mirror=2"}, {": /integrator/bundles/mirror", "unknown"}},
        Setting{"BundleWithoutSize", {"--bundles", "4"}, {"--bundles: expected KIND=SIZE, got '4'"}},
        Setting{"IntegratorOfTwoLines", {"--integrator", "a\nb"}, {"there is no \"a?b\""}},
        Setting{"UnknownAccelerator", {"--accelerator", "magic"}, {"magic", "wide_bvh"}},
        Setting{"UnknownAcceleratorQuality", {"--accelerator-quality", "medium"}, {": /accelerator_quality", "fast, high", "medium"}},
        Setting{"UnknownPixel", {"--pixel", "edge"}, {"edge", "corner"}}, Setting{"UnknownCamera", {"--camera", "drone"}, {"drone"}},
        Setting{"AngleBeyondAPinholes", {"--fov", "180"}, {": camera \"camera\", as changed: \"fov\" must be below 180 degrees, got 180"}},
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
