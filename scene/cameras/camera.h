/// Kinds of cameras.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "kernels/core/params.h"
#include "scene/scene.h"
#include "scene/view.h"

namespace brandung {

class Parameters;

/// Where the eye is, and its axes, of unit length.
struct CameraFrame {
    glm::dvec3 from, forward, right, up;
};

/// [pixels]
struct PictureSize {
    uint width, height;
};

/// Vertical angles of view, from the lower to the upper edge [degrees].
struct FovRange {
    float usual;          ///< if the scene says none; 0: the kind has no such angle
    float limit;          ///< of what a scene may say
    bool limit_included;  ///< in that
};

/// `kernels/cameras/<name>.cl` makes its rays.
struct CameraKind {
    const char *name;  ///< in scene files
    FovRange fov;
    bool sees_everywhere;  ///< whether there is a ray through every point of the picture
    /// What only this kind has.
    void (*read)(const Parameters &parameters, CameraDescription &camera);
    /// What of that a view makes impossible.
    std::optional<ViewFault> (*fault)(const CameraDescription &camera, const CameraFrame &frame);
    /// All but the picture's size.
    Camera (*make)(const CameraDescription &description, const CameraFrame &frame, PictureSize size);
    /// How far from the eye rays begin, at most [world units].
    double (*spread)(const CameraDescription &description, PictureSize size);
};
/// The first is the default.
const std::vector<CameraKind> &camera_kinds();

CameraFrame frame_of(const CameraDescription &description);
/// What is wrong with an angle, if it is.
std::optional<std::string> fov_fault(const FovRange &range, float degrees);
/// For pictures of width x height; of a camera that moves, in its own space, from which its motion leads.
Camera make_camera(const CameraDescription &description, uint width, uint height);

/// The motion of one that moves; no parts of one at rest. `shutter` is the scene's. Nothing if it turns too far in too short a time; scenes' readers
/// refuse such cameras.
std::optional<std::vector<MotionPart>> camera_motion(const CameraDescription &description, const Shutter &shutter);
/// Whether it stands still while its shutter is open.
bool is_at_rest(const CameraDescription &description);
/// The same camera as it is at a time, at rest.
CameraDescription at_rest(const CameraDescription &description, double time);
/// The sharp plane of one that moves stays as far away as it is from where the camera stands first.
void keep_focus_distance(CameraDescription &description);

/// What all kinds have is read by the scene's format; this is the rest, by the kind that "type" names. Throws SceneError.
void read_kind(const Parameters &parameters, CameraDescription &camera);

}  // namespace brandung
