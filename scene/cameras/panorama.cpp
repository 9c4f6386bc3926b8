/// All around.
#include "kernels/cameras/panorama.h"

#include <fmt/format.h>

#include "scene/cameras/make.h"
#include "scene/parameters.h"

namespace brandung {

void read_panorama(const Parameters &parameters, CameraDescription &camera) {
    const float degrees = parameters.positive("horizontal_fov", 360.0f);
    if (degrees > 360) parameters.fail("horizontal_fov", fmt::format("must be at most 360 degrees, got {:g}", degrees));
    camera.horizontal_fov = glm::radians(degrees);
}

Camera make_panorama(const CameraDescription &description, const CameraFrame &frame, PictureSize) {
    const auto turns = [](float radians) { return static_cast<float>(glm::degrees(static_cast<double>(radians)) / 360); };
    return camera_with(frame,
                       Panorama{vec3(frame.forward), vec3(frame.right), vec3(frame.up), turns(description.horizontal_fov), turns(description.fov)});
}

}  // namespace brandung
