/// Which rays stay together, so that packets of them pay. Hits and shadows are the same either way.
#pragma once
#include "runtime/opencl/device.h"
#include "scene/accelerators/accelerator.h"
#include "scene/compile.h"

namespace brandung {

/// Packets pay where one work-item has many rays.
inline bool traces_packets(const Device &device, const CompiledScene &compiled) { return device.info().cpu && compiled.accelerator->packets; }

/// Rays from the eye and their first reflections stay together, the others go their own ways.
inline bool are_coherent(uint generation) { return generation <= 1; }

/// Shadow rays from the first reflections are scattered already: one by one they are faster.
inline bool are_shadow_rays_coherent(uint generation) { return generation == 0; }

}  // namespace brandung
