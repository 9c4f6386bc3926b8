/// Cameras of every kind in scenes of the native format.
#include <gtest/gtest.h>

#include "scene/cameras/camera.h"
#include "tests/scene/formats/native_text.h"

namespace brandung {
namespace {

/// Of the only camera, with these members beside where it looks.
CameraDescription camera_with(const std::string &members) {
    return read_text(R"({"camera": {"from": [0, 0, 5], "at": [0, 0, 0], )" + members + "}}").cameras.at(0);
}
std::string error_of_camera(const std::string &members) {
    return error_of_text("{\"camera\": {\"from\": [0, 0, 5], \"at\": [0, 0, 0],\n" + members + "}}");
}

TEST(NativeCameras, ReadsCamerasOfEveryKind) {
    const CameraDescription orthographic = camera_with(R"("type": "orthographic", "height": 3)");
    EXPECT_EQ(camera_kinds()[orthographic.kind].name, std::string("orthographic"));
    EXPECT_EQ(orthographic.height, 3);
    const CameraDescription lens =
        camera_with(R"("type": "thin_lens", "fov": 30, "lens_radius": 0.1, "focus_at": [1, 2, 3], "blades": 6, "blade_rotation": 15)");
    EXPECT_FLOAT_EQ(lens.fov, glm::radians(30.0f));
    EXPECT_EQ(lens.lens.radius, 0.1f);
    EXPECT_EQ(lens.lens.focus_at, vec3(1, 2, 3));
    EXPECT_EQ(lens.lens.blades, 6u);
    EXPECT_EQ(lens.lens.blade_rotation, 15);
    EXPECT_EQ(camera_with(R"("type": "thin_lens", "lens_radius": 0.1, "focus_distance": 4)").lens.focus_distance, 4);
    const CameraDescription panorama = camera_with(R"("type": "panorama", "horizontal_fov": 90)");
    EXPECT_FLOAT_EQ(panorama.fov, glm::radians(180.0f));
    EXPECT_FLOAT_EQ(panorama.horizontal_fov, glm::radians(90.0f));
    const CameraDescription fisheye = camera_with(R"("type": "fisheye", "fov": 360, "mapping": "equisolid")");
    EXPECT_FLOAT_EQ(fisheye.fov, glm::radians(360.0f));
    EXPECT_TRUE(fisheye.equisolid);
}

TEST(NativeCameras, RefusesWhatAKindOfCameraCannotBe) {
    EXPECT_EQ(error_of_camera(R"("type": "pinhole")"),
              ":2: /camera/type: must be one of perspective, orthographic, thin_lens, panorama, fisheye, got \"pinhole\"");
    EXPECT_EQ(error_of_camera(R"("lens_radius": 1)"),
              ":2: /camera/lens_radius: unknown key; known here: inside, keys, name, at, from, shutter, up, fov, type");
    EXPECT_EQ(error_of_camera(R"("type": "orthographic")"), ":1: /camera: \"height\" is missing");
    EXPECT_EQ(error_of_camera(R"("type": "orthographic", "height": 0)"), ":2: /camera/height: must be positive, got 0");
    EXPECT_EQ(error_of_camera(R"("type": "orthographic", "height": 1, "fov": 40)"),
              ":2: /camera/fov: unknown key; known here: from, at, up, keys, name, type, height, inside, shutter");
    const std::string lens = R"("type": "thin_lens", "lens_radius": 1)";
    EXPECT_EQ(error_of_camera(R"("type": "thin_lens", "focus_distance": 1)"), ":1: /camera: \"lens_radius\" is missing");
    EXPECT_EQ(error_of_camera(lens), ":1: /camera: needs either \"focus_distance\" or \"focus_at\"");
    EXPECT_EQ(error_of_camera(lens + R"(, "focus_distance": 1, "focus_at": [0, 0, 0])"),
              ":2: /camera/focus_at: the camera has both \"focus_distance\" and \"focus_at\", but needs only one of them");
    EXPECT_EQ(error_of_camera(lens + R"(, "focus_distance": -1)"), ":2: /camera/focus_distance: must be positive, got -1");
    EXPECT_EQ(error_of_camera(lens + R"(, "focus_at": [1, 1, 5])"), ":2: /camera/focus_at: must lie in front of the eye");
    EXPECT_EQ(error_of_camera(lens + R"(, "focus_distance": 1, "blades": 2)"), ":2: /camera/blades: must be 0, or at least 3, got 2");
    EXPECT_EQ(error_of_camera(lens + R"(, "focus_distance": 1, "blade_rotation": 2)"),
              ":2: /camera/blade_rotation: the aperture is round, it has no \"blades\"");
    EXPECT_EQ(error_of_camera(lens + R"(, "focus_distance": 1, "fov": 180)"), ":2: /camera/fov: must be below 180 degrees, got 180");
    EXPECT_EQ(error_of_camera(R"("type": "panorama", "fov": 181)"), ":2: /camera/fov: must be at most 180 degrees, got 181");
    EXPECT_EQ(error_of_camera(R"("type": "panorama", "horizontal_fov": 361)"), ":2: /camera/horizontal_fov: must be at most 360 degrees, got 361");
    EXPECT_EQ(error_of_camera(R"("type": "fisheye", "fov": 361)"), ":2: /camera/fov: must be at most 360 degrees, got 361");
    EXPECT_EQ(error_of_camera(R"("type": "fisheye", "mapping": "flat")"), ":2: /camera/mapping: must be one of equidistant, equisolid, got \"flat\"");
}

}  // namespace
}  // namespace brandung
