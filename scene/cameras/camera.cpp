#include "scene/cameras/camera.h"

#include <fmt/format.h>

#include <cmath>

#include "scene/parameters.h"

namespace brandung {
namespace {

void read_fov(const Parameters &parameters, const FovRange &range, CameraDescription &camera) {
    if (range.usual == 0) return;
    const float degrees = parameters.positive("fov", range.usual);
    if (const auto fault = fov_fault(range, degrees)) parameters.fail("fov", *fault);
    camera.fov = glm::radians(degrees);
}

}  // namespace

std::optional<std::string> fov_fault(const FovRange &range, float degrees) {
    if (degrees < range.limit || (degrees == range.limit && range.limit_included)) return std::nullopt;
    return fmt::format("must be {} {:g} degrees, got {:g}", range.limit_included ? "at most" : "below", range.limit, degrees);
}

CameraFrame frame_of(const CameraDescription &description) {
    const glm::dvec3 from(description.from), forward = glm::normalize(glm::dvec3(description.at) - from);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(description.up)));
    return {from, forward, right, glm::cross(right, forward)};
}

Camera make_camera(const CameraDescription &description, uint width, uint height) {
    Camera camera = camera_kinds()[description.kind].make(description, frame_of(description), {width, height});
    camera.width = width, camera.height = height;
    return camera;
}

void read_kind(const Parameters &parameters, CameraDescription &camera) {
    std::vector<std::string> names;
    for (const CameraKind &kind : camera_kinds()) names.emplace_back(kind.name);
    camera.kind = parameters.choice("type", names, 0);
    const CameraKind &kind = camera_kinds()[camera.kind];
    read_fov(parameters, kind.fov, camera);
    kind.read(parameters, camera);
}

}  // namespace brandung
