/// A lens without thickness.
#include "kernels/cameras/thin_lens.h"

#include <fmt/format.h>

#include "scene/cameras/make.h"
#include "scene/cameras/picture_plane.h"
#include "scene/parameters.h"

namespace brandung {
namespace {

constexpr uint max_blades = 1000;  ///< beyond any that can be told from a circle

/// Of the sharp plane, along the view.
double focus_distance(const LensDescription &lens, const CameraFrame &frame) {
    if (!lens.focus_at) return static_cast<double>(lens.focus_distance);
    return glm::dot(glm::dvec3(*lens.focus_at) - frame.from, frame.forward);
}

void read_focus(const Parameters &parameters, LensDescription &lens) {
    if (parameters.has("focus_at") && parameters.has("focus_distance"))
        parameters.fail("focus_at", "the camera has both \"focus_distance\" and \"focus_at\", but needs only one of them");
    if (parameters.has("focus_at"))
        lens.focus_at = parameters.vector("focus_at");
    else if (parameters.has("focus_distance"))
        lens.focus_distance = parameters.positive("focus_distance");
    else
        parameters.fail("", "needs either \"focus_distance\" or \"focus_at\"");
}

}  // namespace

void read_thin_lens(const Parameters &parameters, CameraDescription &camera) {
    LensDescription &lens = camera.lens;
    lens.radius = parameters.positive("lens_radius");
    read_focus(parameters, lens);
    lens.blades = parameters.integer("blades", 0, 0, max_blades);
    if (lens.blades == 1 || lens.blades == 2) parameters.fail("blades", fmt::format("must be 0, or at least 3, got {}", lens.blades));
    lens.blade_rotation = parameters.number("blade_rotation", 0);
    if (lens.blade_rotation != 0 && lens.blades == 0) parameters.fail("blade_rotation", "the aperture is round, it has no \"blades\"");
}

std::optional<ViewFault> fault_of_thin_lens(const CameraDescription &camera, const CameraFrame &frame) {
    if (focus_distance(camera.lens, frame) > 0) return std::nullopt;
    return ViewFault{"focus_at", "must lie in front of the eye"};
}

Camera make_thin_lens(const CameraDescription &description, const CameraFrame &frame, PictureSize size) {
    const LensDescription &lens = description.lens;
    const double distance = focus_distance(lens, frame), half_height = distance * half_height_of(description), radius = double(lens.radius);
    const PicturePlane plane = picture_plane(frame, distance, half_height, size);
    const double turns = static_cast<double>(lens.blade_rotation) / 360;
    return camera_with(frame, ThinLens{.corner = plane.corner,
                                       .right = plane.right,
                                       .down = plane.down,
                                       .across = vec3(radius * frame.right),
                                       .along = vec3(radius * frame.up),
                                       .blades = static_cast<float>(lens.blades),
                                       .turned = static_cast<float>(turns - std::floor(turns))});
}

double spread_of_thin_lens(const CameraDescription &description, PictureSize) { return static_cast<double>(description.lens.radius); }

}  // namespace brandung
