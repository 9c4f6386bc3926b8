/// What is mistyped is answered with what may have been meant.
#include <gtest/gtest.h>

#include "tests/tools/runs.h"
#include "tests/tools/scenes.h"

namespace {

/// The one line that the program ends with when it refuses to render.
std::string refusal(const TemporaryFolder &folder, const std::string &scene, const std::vector<std::string> &more, int status) {
    std::vector<std::string> arguments = {"render", folder.write("scene.json", scene), "-o", folder.path("out.png"), "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Finished run = run_program(arguments);
    EXPECT_EQ(run.status, status) << run.err;
    EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
    return run.err;
}

void expect_part(const std::string &text, const std::string &part) { EXPECT_NE(text.find(part), std::string::npos) << part << "\nin " << text; }

}  // namespace

TEST(CliHints, OptionsThatAreMisspelt) {
    const TemporaryFolder folder;
    expect_part(refusal(folder, native_scene(), {"--ssp", "4"}, 2), "; is --spp meant?");
    expect_part(refusal(folder, native_scene(), {"--light-sample=4"}, 2), "; is --light-samples meant?");
    EXPECT_EQ(refusal(folder, native_scene(), {"--nothing-like-it"}, 2).find("meant?"), std::string::npos);
}

TEST(CliHints, ValuesOfOptions) {
    const TemporaryFolder folder;
    expect_part(refusal(folder, native_scene(), {"--camera", "c"}, 1), "there is no camera 'c', only 'camera'");
    expect_part(refusal(folder, native_scene(), {"--background", "blue"}, 2), "expected a colour, as #RRGGBB, R,G,B or one number, or a picture");
    expect_part(refusal(folder, native_scene(), {"--spp", "ten"}, 2), "--spp: must be a whole number from 1 to 16777216, got 'ten'");
}

/// Those that emissive shapes become are none to be named.
TEST(CliHints, LightsThatFilesCannotName) {
    const TemporaryFolder folder;
    const Finished run = run_program(
        {"check", folder.write("scene.json", R"({"camera": {"from": [0, 0, 4], "at": [0, 0, 0]}, "lights": [{"type": "emissive_sphere"}]})")});
    EXPECT_EQ(run.status, 1) << "signal " << run.signal << run.err;
    expect_part(run.err, "/lights/0/type: must be one of point, directional, spot, got \"emissive_sphere\"");
}

/// Of materials that meshes bring along, objects name none, and none is offered.
TEST(CliHints, MaterialsOfFilesAreNotForObjects) {
    const TemporaryFolder folder;
    folder.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string mesh = R"({"type": "mesh", "file": "mesh.obj"})", groups = R"("groups": [{"name": "g", "objects": [)" + mesh + "]}],";
    expect_part(refusal(folder, native_scene(R"({"type": "sphere", "material": "mesh.obj:no material"})", groups), {}, 1),
                "must be one of grey, got \"mesh.obj:no material\"");
}

TEST(CliHints, ReflectancesAboveOneAreMentioned) {
    const TemporaryFolder folder;
    const Finished run = run_program({"check", folder.write("scene.json", native_scene()), "--set", "materials.0.diffuse=[255,0,0]"});
    expect_success(run);
    expect_part(run.out, "warning: diffuse reflectance above 1: ");
}
