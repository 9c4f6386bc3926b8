/// Samplers: where in their pixels samples lie. `kernels/samplers/<name>.cl` draws them.
#pragma once
#include <vector>

namespace brandung {

struct SamplerKind {
    const char *name;
};
const std::vector<SamplerKind> &sampler_kinds();

}  // namespace brandung
