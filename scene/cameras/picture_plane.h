/// Pictures that lie in a plane across the view.
#pragma once
#include <cmath>

#include "scene/cameras/camera.h"

namespace brandung {

/// From the eye to the picture's upper left corner, and its edges to the right and down.
struct PicturePlane {
    vec3 corner, right, down;
};

/// So many world units in front of the eye.
inline PicturePlane picture_plane(const CameraFrame &frame, double distance, double half_height, PictureSize size) {
    const double half_width = half_height * size.width / size.height;
    return {.corner = vec3(distance * frame.forward - half_width * frame.right + half_height * frame.up),
            .right = vec3(2 * half_width * frame.right),
            .down = vec3(-2 * half_height * frame.up)};
}

/// Of what a pinhole sees at distance 1.
inline double half_height_of(const CameraDescription &description) { return std::tan(0.5 * static_cast<double>(description.fov)); }

}  // namespace brandung
