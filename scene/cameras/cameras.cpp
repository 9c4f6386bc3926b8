/// The list of cameras.
#include "scene/cameras/make.h"

namespace brandung {

void read_orthographic(const Parameters &parameters, CameraDescription &camera);
void read_thin_lens(const Parameters &parameters, CameraDescription &camera);
void read_panorama(const Parameters &parameters, CameraDescription &camera);
void read_fisheye(const Parameters &parameters, CameraDescription &camera);
Camera make_perspective(const CameraDescription &description, const CameraFrame &frame, PictureSize size);
Camera make_orthographic(const CameraDescription &description, const CameraFrame &frame, PictureSize size);
Camera make_thin_lens(const CameraDescription &description, const CameraFrame &frame, PictureSize size);
Camera make_panorama(const CameraDescription &description, const CameraFrame &frame, PictureSize size);
Camera make_fisheye(const CameraDescription &description, const CameraFrame &frame, PictureSize size);
std::optional<ViewFault> fault_of_thin_lens(const CameraDescription &camera, const CameraFrame &frame);
double spread_of_orthographic(const CameraDescription &description, PictureSize size);
double spread_of_thin_lens(const CameraDescription &description, PictureSize size);

const std::vector<CameraKind> &camera_kinds() {
    static const std::vector<CameraKind> kinds = {
        {"perspective", {45, 180, false}, true, read_nothing, no_fault, make_perspective, no_spread},
        {"orthographic", {0, 0, false}, true, read_orthographic, no_fault, make_orthographic, spread_of_orthographic},
        {"thin_lens", {45, 180, false}, true, read_thin_lens, fault_of_thin_lens, make_thin_lens, spread_of_thin_lens},
        {"panorama", {180, 180, true}, true, read_panorama, no_fault, make_panorama, no_spread},
        {"fisheye", {180, 360, true}, false, read_fisheye, no_fault, make_fisheye, no_spread},
    };
    return kinds;
}

}  // namespace brandung
