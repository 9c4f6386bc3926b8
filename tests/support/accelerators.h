/// Accelerators built while nobody watches.
#pragma once
#include <string>

#include "scene/accelerators/accelerator.h"

namespace brandung {

inline BuildProgress unwatched;

inline BuiltAccelerator build_accelerator(const std::string &name, std::span<const Reference> references, BuildQuality quality = BuildQuality::fast) {
    return find_accelerator(name).build(
        references, [&](uint i) { return hull_of_box(references[i].bounds); }, quality, unwatched);
}

}  // namespace brandung
