/// Disagreement: how many rays of a queue two tracers answer differently, and who is wrong.
#pragma once
#include <functional>
#include <optional>

#include "runtime/accelerators/ray_tracing.h"
#include "tools/bench/judge.h"

namespace brandung {

struct Disagreement {
    /// Rays of which one meets something and the other nothing, or whose closest hits are on different primitives, or whose t differ by more than
    /// 2^-12.
    std::uint64_t mismatches = 0;
    std::uint64_t judged = 0;  ///< all of these, those whose t differ by more than 2^-20, and every 16th ray
    std::uint64_t ours_wrong = 0, theirs_wrong = 0;
    std::uint64_t ambiguous = 0;  ///< mismatches of which neither is wrong
};

/// Nothing where `goes_on` has ended it.
std::optional<Disagreement> compare_answers(const Judge &judge, const RayQueue &queue, const RayAnswers &ours, const RayAnswers &theirs,
                                            const std::function<bool()> &goes_on);

}  // namespace brandung
