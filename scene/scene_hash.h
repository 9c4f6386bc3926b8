/// A hash of what a scene shows.
#pragma once
#include <cstdint>

#include "scene/compile.h"

namespace brandung {

/// Of primitives, materials, lights, background, ambient light and cameras, whatever the accelerator and the file. `compiled` is `scene`, compiled.
std::uint64_t scene_hash(const Scene &scene, const CompiledScene &compiled);

}  // namespace brandung
