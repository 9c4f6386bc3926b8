/// What the traversals of wide_bvh have room for.
#pragma once
#include "kernels/accelerators/wide_bvh.h"
#include "scene/accelerators/accelerator.h"

namespace brandung {

struct WideBvhLimits {
    uint levels = BVH_LEVELS;    ///< nodes on the way from the root to any other, both among them
    uint pending = BVH_PENDING;  ///< entries on the stack of a ray that meets all boxes and visits the children in the worst order
};

/// The build of the kind. A tree that exceeds the limits is built anew, more and more balanced. Throws SceneError if that does not help.
BuiltAccelerator build_wide_bvh_within(const WideBvhLimits &limits, std::span<const Reference> references, BuildQuality quality,
                                       BuildProgress &progress);

}  // namespace brandung
