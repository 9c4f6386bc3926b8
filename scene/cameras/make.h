/// What kinds of cameras share.
#pragma once
#include "scene/cameras/camera.h"
#include "scene/kinds.h"

namespace brandung {

/// A camera at the eye with its kind's own view of the words.
template <class View> Camera camera_with(const CameraFrame &frame, const View &view) {
    Camera camera{};
    camera.position = vec3(frame.from);
    write_words(view, camera.words);
    return camera;
}

/// Of kinds whose rays all begin at the eye.
inline double no_spread(const CameraDescription &, PictureSize) { return 0; }

/// Of kinds that have no parameters of their own.
inline void read_nothing(const Parameters &, CameraDescription &) {}

/// Of kinds that every view does for.
inline std::optional<ViewFault> no_fault(const CameraDescription &, const CameraFrame &) { return std::nullopt; }

}  // namespace brandung
