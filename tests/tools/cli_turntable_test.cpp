/// Sequences of pictures: what belongs to each picture, and what to all of them.
#include <gtest/gtest.h>

#include "tests/tools/runs.h"
#include "tests/tools/scenes.h"
#include "tests/tools/stored_picture.h"

namespace {

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

}  // namespace
