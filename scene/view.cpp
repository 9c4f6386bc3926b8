#include "scene/view.h"

namespace brandung {

std::optional<ViewFault> view_fault(const CameraDescription &camera) {
    const glm::dvec3 view = glm::dvec3(camera.at) - glm::dvec3(camera.from), up(camera.up);
    if (camera.from == camera.at) return ViewFault{"at", "must differ from \"from\""};
    if (camera.up == vec3(0)) return ViewFault{"up", "must not be zero"};
    if (glm::length(glm::cross(view, up)) < 1e-6 * glm::length(view) * glm::length(up))
        return ViewFault{"up", "must not be parallel to the view from \"from\" to \"at\""};
    return std::nullopt;
}

}  // namespace brandung
