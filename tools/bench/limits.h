/// What a device can do at most, measured.
#pragma once
#include "runtime/opencl/device.h"

namespace brandung {

struct Limits {
    double copy_bytes_per_second;  ///< read and written together, of arrays of 64 MiB each
    double flops_per_second;       ///< single precision, a multiply-add being two
    double launch_seconds;         ///< that an empty launch takes
};

/// Medians; takes about a second.
Limits measure_limits(Device &device);

}  // namespace brandung
