#include "scene/view.h"

#include <fmt/format.h>

#include <cmath>

#include "scene/cameras/camera.h"

namespace brandung {

std::optional<ViewFault> view_fault(const CameraDescription &camera) {
    const glm::dvec3 view = glm::dvec3(camera.at) - glm::dvec3(camera.from), up(camera.up);
    if (camera.from == camera.at) return ViewFault{"at", "must differ from \"from\""};
    if (camera.up == vec3(0)) return ViewFault{"up", "must not be zero"};
    if (glm::length(glm::cross(view, up)) < 1e-6 * glm::length(view) * glm::length(up))
        return ViewFault{"up", "must not be parallel to the view from \"from\" to \"at\""};
    const CameraKind &kind = camera_kinds()[camera.kind];
    if (kind.fov.usual > 0)
        if (const auto fault = fov_fault(kind.fov, glm::degrees(camera.fov))) return ViewFault{"fov", *fault};
    return kind.fault(camera, frame_of(camera));
}

void ViewChanges::apply(CameraDescription &camera) const {
    if (from || at || up) camera.keys.clear();
    camera.from = from.value_or(camera.from), camera.at = at.value_or(camera.at), camera.up = up.value_or(camera.up);
    camera.fov = fov.value_or(camera.fov);
}

std::string view_options(const CameraDescription &camera) {
    const auto numbers = [](vec3 v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
    std::string options = fmt::format("--from {} --at {} --up {}", numbers(camera.from), numbers(camera.at), numbers(camera.up));
    if (camera_kinds()[camera.kind].fov.usual > 0) options += fmt::format(" --fov {:.4g}", glm::degrees(camera.fov));
    return options;
}

/// Rodrigues' formula.
vec3 turned(vec3 p, const CameraDescription &camera, double angle) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(camera.up)), at(camera.at), way = glm::dvec3(p) - at;
    return vec3(at + way * std::cos(angle) + glm::cross(axis, way) * std::sin(angle) + axis * glm::dot(axis, way) * (1 - std::cos(angle)));
}

CameraDescription turned(const CameraDescription &camera, double angle) {
    CameraDescription result = camera;
    result.from = turned(camera.from, camera, angle);
    for (CameraKey &key : result.keys) {
        const vec3 above = turned(key.at + key.up, camera, angle);
        key.from = turned(key.from, camera, angle), key.at = turned(key.at, camera, angle), key.up = above - key.at;
    }
    return result;
}

}  // namespace brandung
