/// Disagreement: how many rays of a queue two tracers answer differently, and who is wrong.
#pragma once
#include "runtime/accelerators/ray_tracing.h"
#include "tools/bench/scene_geometry.h"

namespace brandung {

struct Disagreement {
    /// Rays of which one meets something and the other nothing, or whose closest hits are on different primitives, or whose t differ by more than
    /// 2^-12.
    std::uint64_t mismatches = 0;
    std::uint64_t judged = 0;  ///< of these, evenly spread; all but where that would take too long
    std::uint64_t ours_wrong = 0, theirs_wrong = 0;
    std::uint64_t ambiguous = 0;  ///< judged, and neither is wrong
};

Disagreement compare_answers(const SceneGeometry &geometry, const RayQueue &queue, const RayAnswers &ours, const RayAnswers &theirs);

}  // namespace brandung
