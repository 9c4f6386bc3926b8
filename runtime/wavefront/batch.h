/// Batch: the part of a picture that is rendered at once.
#pragma once
#include "kernels/core/items.h"
#include "kernels/core/params.h"
#include "kernels/primitives/motion.h"
#include "runtime/opencl/buffer.h"

namespace brandung {

class Aovs;

/// Rays of a wave: many enough that launches are few (twice as many as 32768 took 4 to 5 % less time in boxes, on two cores), and so few that what
/// they know stays in a processor's last cache.
inline constexpr uint default_batch = 65536;

/// A list of pixels (x in the lower 16 bits, y in the upper) and a range of their samples.
struct Batch {
    BatchParams params;
    const Buffer<uint> &pixels;
    Camera camera;
    ShutterParams shutter;
    const Buffer<MotionPart> &camera_motion;  ///< so many parts as the shutter says
    const std::vector<uint> &interior;        ///< the list of media that the eye is in, as kernels/core/interior.cl has it
    Aovs *aovs = nullptr;                     ///< takes note of what camera rays hit, if anyone wants to know
    uint count() const { return params.pixels * params.samples; }
};

}  // namespace brandung
