/// What a camera needs so that its view is defined, and how it can be changed.
#pragma once
#include <optional>
#include <string>

#include "scene/scene.h"

namespace brandung {

/// The key of a camera that is at fault, and why.
struct ViewFault {
    const char *key;
    std::string why;
};

/// Views have a direction, which leaves open no more than a millionth which way is up, and what their kind of camera needs; nothing if this one does.
std::optional<ViewFault> view_fault(const CameraDescription &camera);

/// What of a camera is to be replaced. One whose view is replaced is at rest.
struct ViewChanges {
    std::optional<vec3> from, at, up;
    std::optional<float> fov;  ///< full vertical angle [radians]

    void apply(CameraDescription &camera) const;
};

/// The options that give the view of a camera: "--from 1,2,3 --at 0,0,0 --up 0,1,0 --fov 45".
std::string view_options(const CameraDescription &camera);

/// A point turned by an angle [radians] around the axis through the camera's `at` along its `up`, counterclockwise as seen from above.
vec3 turned(vec3 p, const CameraDescription &camera, double angle);
/// The camera itself, turned so.
CameraDescription turned(const CameraDescription &camera, double angle);

}  // namespace brandung
