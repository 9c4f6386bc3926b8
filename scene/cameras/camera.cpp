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

/// Of a camera that moves, in its own space.
const CameraFrame own_frame = {{0, 0, 0}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}};

/// From the space of the camera to the world.
AffineMap map_of(const CameraFrame &frame) { return {{frame.right, frame.up, -frame.forward}, frame.from}; }

Motion motion_of(const CameraDescription &description) {
    std::vector<MotionKey> keys;
    for (const CameraKey &key : description.keys) keys.push_back({key.time, map_of(frame_of({.from = key.from, .at = key.at, .up = key.up}))});
    return Motion(keys);
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

std::optional<std::vector<MotionPart>> camera_motion(const CameraDescription &description, const Shutter &shutter) {
    if (description.keys.empty()) return std::vector<MotionPart>();
    return motion_parts(motion_of(description), shutter, {vec3(-1), vec3(1)});
}

bool is_at_rest(const CameraDescription &description) { return description.keys.empty() || motion_of(description).is_at_rest(description.shutter); }

void keep_focus_distance(CameraDescription &description) {
    LensDescription &lens = description.lens;
    if (!lens.focus_at) return;
    const CameraFrame frame = frame_of(description);
    lens.focus_distance = static_cast<float>(glm::dot(glm::dvec3(*lens.focus_at) - frame.from, frame.forward));
    lens.focus_at.reset();
}

CameraDescription at_rest(const CameraDescription &description, double time) {
    CameraDescription result = description;
    result.keys.clear();
    if (description.keys.empty()) return result;
    for (const CameraKey &key : description.keys)
        if (key.time == time) {
            result.from = key.from, result.at = key.at, result.up = key.up;
            return result;
        }
    const AffineMap map = motion_of(description).at(time);
    result.from = vec3(map.offset), result.at = vec3(map.offset - map.linear[2]), result.up = vec3(map.linear[1]);
    return result;
}

Camera make_camera(const CameraDescription &description, uint width, uint height) {
    const CameraFrame frame = description.keys.empty() ? frame_of(description) : own_frame;
    Camera camera = camera_kinds()[description.kind].make(description, frame, {width, height});
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
