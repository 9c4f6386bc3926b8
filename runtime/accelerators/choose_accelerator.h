/// The accelerator `auto`: every one is tried on a sample of the scene's own rays.
#pragma once
#include <vector>

#include "runtime/opencl/device.h"
#include "scene/accelerators/accelerator.h"
#include "scene/compile.h"

namespace brandung {

/// How one would do.
struct TriedAccelerator {
    const AcceleratorKind *kind;
    double build_seconds = 0;
    double trace_seconds = 0;  ///< that all rays of the render would take; infinite if it was given up
    double expected_seconds() const { return build_seconds + trace_seconds; }
};

struct AcceleratorChoice {
    std::vector<TriedAccelerator> trials;  ///< the best first
    std::uint64_t rays = 0;                ///< that the render will trace, about
    std::uint64_t rays_tried = 0;          ///< by each
};

/// Whom to tell what is tried now, and what of it is built.
struct ChoiceWatch {
    std::function<void(const AcceleratorKind &kind)> on_trial;
    WatchAccelerator on_accelerator;
};

/// Takes some of the rays of the scene's first samples, builds one accelerator after another and traces the same rays with each as a render does,
/// in waves of `batch`. One whose building takes much longer than the best so far would take for everything is given up; so is `none` for more
/// primitives than a few. What the best gains is that the render takes its time to build and to trace, so the sum of both decides.
/// Throws SceneError and Error.
AcceleratorChoice choose_accelerator(Device &device, const Scene &scene, const CameraDescription &camera, uint batch, const ChoiceWatch &watch = {});

/// What was tried, and how long each would take: one line.
std::string text_of(const AcceleratorChoice &choice);

}  // namespace brandung
