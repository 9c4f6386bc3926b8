/// A circle full of directions.
#include "kernels/cameras/fisheye.h"

#include "scene/cameras/make.h"
#include "scene/parameters.h"

namespace brandung {

void read_fisheye(const Parameters &parameters, CameraDescription &camera) {
    camera.equisolid = parameters.choice("mapping", {"equidistant", "equisolid"}, 0) == 1;
}

Camera make_fisheye(const CameraDescription &description, const CameraFrame &frame, PictureSize size) {
    const double half_angle = 0.5 * static_cast<double>(description.fov);
    return camera_with(frame, Fisheye{.forward = vec3(frame.forward),
                                      .right = vec3(frame.right),
                                      .up = vec3(frame.up),
                                      .aspect = static_cast<float>(size.width) / static_cast<float>(size.height),
                                      .angle = static_cast<float>(glm::degrees(half_angle) / 360),
                                      .sine = static_cast<float>(std::sin(0.5 * half_angle)),
                                      .equisolid = description.equisolid ? 1.0f : 0.0f});
}

}  // namespace brandung
