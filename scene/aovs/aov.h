/// AOVs: what a picture can have beside radiance.
#pragma once
#include <string>
#include <vector>

#include "kernels/core/portable.h"

namespace brandung {

struct AovKind {
    const char *name;
    /// `mean`: of a value that `kernels/aovs/<name>.cl` records of every sample's first hit. `number`: of what
    /// the first sample hits, as `kernels/aovs/<name>.cl` has it. `count`: of samples.
    enum { mean, number, count } what;
    bool length;                        ///< a mean is in world units; else its components are within [-1, 1]
    std::vector<std::string> channels;  ///< at most 3 for means
    float nothing;                      ///< the mean where no sample has a value
};
const std::vector<AovKind> &aov_kinds();

}  // namespace brandung
