/// Cameras of every kind.
#pragma once
#include <string>
#include <vector>

#include "scene/cameras/camera.h"
#include "scene/kinds.h"

namespace brandung {

/// One that looks a little down, with something in all of its kind's parameters.
inline CameraDescription camera_of_kind(const std::string &kind) {
    CameraDescription camera{.name = "camera", .from = {0.7f, 0.4f, 3}, .at = {0.1f, -0.2f, 0}, .up = {0.1f, 1, 0.2f}};
    camera.kind = kind_number(camera_kinds(), kind);
    camera.fov = glm::radians(kind == "fisheye" ? 250.0f : kind == "panorama" ? 160.0f : 50.0f);
    camera.height = 2.5f;
    camera.horizontal_fov = glm::radians(300.0f);
    camera.lens = {.radius = 0.2f, .focus_distance = 2.5f};
    return camera;
}

inline std::vector<std::string> camera_names() {
    std::vector<std::string> names;
    for (const CameraKind &kind : camera_kinds()) names.emplace_back(kind.name);
    return names;
}

}  // namespace brandung
