/// Parallel rays.
#include "kernels/cameras/orthographic.h"

#include "scene/cameras/make.h"
#include "scene/cameras/picture_plane.h"
#include "scene/parameters.h"

namespace brandung {

void read_orthographic(const Parameters &parameters, CameraDescription &camera) { camera.height = parameters.positive("height"); }

Camera make_orthographic(const CameraDescription &description, const CameraFrame &frame, PictureSize size) {
    const double half_height = 0.5 * static_cast<double>(description.height);
    const PicturePlane plane = picture_plane(frame, 0, half_height, size);
    return camera_with(frame, Orthographic{plane.corner, plane.right, plane.down, vec3(frame.forward)});
}

/// To a corner.
double spread_of_orthographic(const CameraDescription &description, PictureSize size) {
    return 0.5 * static_cast<double>(description.height) * std::hypot(1.0, static_cast<double>(size.width) / size.height);
}

}  // namespace brandung
