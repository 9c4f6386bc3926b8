/// AOVs: what a picture can have beside radiance.
#pragma once
#include <string>
#include <vector>

#include "kernels/core/portable.h"

namespace brandung {

struct AovKind {
    const char *name;
    /// `kernels/aovs/<name>.cl` records values or numbers of first hits. `filtered`: the mean of all samples, weighed as their radiance is, of a
    /// value within [-1, 1]. `length`: the mean of those samples that hit something, of a value in world units; all count the same, so that it lies
    /// between theirs where a filter is negative too. `number`: of what the first sample hits. `count`: of samples. `error`: standard error of
    /// radiance, from the film alone.
    enum { filtered, length, number, count, error } what;
    std::vector<std::string> channels;  ///< at most 3 of values
    float nothing;                      ///< the mean where no sample has a value
};
const std::vector<AovKind> &aov_kinds();

}  // namespace brandung
