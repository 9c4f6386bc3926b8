/// Axis-aligned boxes.
#pragma once
#include <limits>

#include "kernels/core/portable.h"

namespace brandung {

struct Bounds {
    vec3 low{std::numeric_limits<float>::infinity()};
    vec3 high{-std::numeric_limits<float>::infinity()};

    void add(vec3 p) { low = glm::min(low, p), high = glm::max(high, p); }
    void add(const Bounds &other) { low = glm::min(low, other.low), high = glm::max(high, other.high); }
    bool empty() const { return low.x > high.x; }
};

}  // namespace brandung
