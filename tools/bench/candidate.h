/// Candidate: one of the accelerators that a bench compares.
#pragma once
#include <functional>
#include <string>

#include "runtime/accelerators/ray_tracing.h"
#include "scene/accelerators/accelerator.h"

namespace brandung {

/// A scene with one accelerator on the device.
struct Candidate {
    /// `see_arena` is shown the compiled scene while it still has its arena.
    Candidate(Device &device, const Scene &scene, const std::string &accelerator, uint batch,
              const std::function<void(const CompiledScene &)> &see_arena = {})
        : compiled(compile(scene, {.accelerator = &find_accelerator(accelerator), .limit = limit_of(device)})),
          on_device(device, compiled),
          tracing(device, compiled, on_device, batch) {
        if (see_arena) see_arena(compiled);
        compiled.arena = {};  // the device has it
    }
    CompiledScene compiled;
    DeviceScene on_device;
    RayTracing tracing;
};

}  // namespace brandung
