/// Sequences of pictures: what belongs to each picture, and what to all of them.
#include <gtest/gtest.h>

#include "scene/image.h"
#include "tests/tools/runs.h"
#include "tests/tools/scenes.h"
#include "tests/tools/stored_picture.h"

namespace {

using namespace brandung;

float middle_of(const std::string &file, const char *channel) {
    const StoredPicture picture = read_stored(file);
    const std::size_t pixel = std::size_t(picture.spec.height / 2 * picture.spec.width + picture.spec.width / 2);
    return picture.values.at(pixel * std::size_t(picture.spec.nchannels) + std::size_t(picture.spec.channelindex(channel)));
}

/// The eye at (0, 0, 4) looks at (0, 0, -150), past the unit sphere about the origin; half around it is at (0, 0, -304), and 303 away from the
/// sphere.
TEST(Turntable, LengthsReachAsFarAsItsCamerasAre) {
    const TemporaryFolder folder;
    render_quietly({folder.write("scene.json", native_scene()), "--aov", "depth,position", "--at", "0,0,-150", "--fov", "1", "--turntable", "2", "-o",
                    folder.path("t.exr")});
    EXPECT_NEAR(middle_of(folder.path("t_000.exr"), "depth.Z"), 3, 0.01);
    EXPECT_NEAR(middle_of(folder.path("t_001.exr"), "depth.Z"), 303, 0.05);
    EXPECT_NEAR(middle_of(folder.path("t_001.exr"), "P.Z"), -1, 0.05);
}

/// Lit from one side, a sphere is dark from behind: an exposure of each picture's own would hide that.
TEST(Turntable, AutomaticExposureIsThatOfTheFirstPicture) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", native_scene());
    const Finished run = run_program({"render", "--quiet", scene, "--exposure", "auto", "--turntable", "2", "-o", folder.path("t.png")});
    expect_success(run);
    expect_success(run_program({"render", "--quiet", scene, "--exposure", "auto", "-o", folder.path("first.png")}));
    const std::string exposure = read_stored(folder.path("first.png")).text("brandung:exposure");
    EXPECT_EQ(run.err, "exposure: --exposure " + exposure + ", which the first picture has chosen\n");
    EXPECT_EQ(read_stored(folder.path("t_000.png")).values, read_stored(folder.path("first.png")).values);
    EXPECT_EQ(read_stored(folder.path("t_001.png")).text("brandung:exposure"), exposure);
    EXPECT_LT(middle_of(folder.path("t_001.png"), "R"), middle_of(folder.path("t_000.png"), "R"));
}

/// Picture i of n is what the camera sees that has been turned by i / n of a circle; the first is that of the scene's camera.
TEST(Turntable, IsASequenceOfTurnedCameras) {
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
TEST(Turntable, HeadlightGoesWithTheCamera) {
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

}  // namespace
