/// Pinhole camera.
#include "kernels/cameras/perspective.h"

#include "scene/cameras/make.h"
#include "scene/cameras/picture_plane.h"

namespace brandung {

Camera make_perspective(const CameraDescription &description, const CameraFrame &frame, PictureSize size) {
    const double half_height = half_height_of(description);
    const PicturePlane plane = picture_plane(frame, 1, half_height, size);
    return camera_with(frame, Perspective{plane.corner, plane.right, plane.down});
}

}  // namespace brandung
