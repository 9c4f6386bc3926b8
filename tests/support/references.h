/// Boxes that builders of accelerators must cope with.
#pragma once
#include <cfloat>
#include <cmath>
#include <random>
#include <vector>

#include "scene/accelerators/accelerator.h"

namespace brandung {

using References = std::vector<Reference>;

inline References random_boxes(uint count, uint kinds, float size) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0, 1);
    References references(count);
    for (Reference &reference : references) {
        const vec3 low(unit(random), unit(random), unit(random));
        reference.bounds = {low, low + size * vec3(unit(random), unit(random), unit(random))};
        reference.kind = random() % kinds;
    }
    return references;
}

inline References scaled(References references, vec3 scale) {
    for (Reference &reference : references) {
        reference.bounds.low *= scale;
        reference.bounds.high *= scale;
    }
    return references;
}

/// Boxes with a corner in common, each a little larger than the last: SAH takes them off one by one.
inline References nest(uint count) {
    References references;
    for (uint i = 0; i < count; ++i) {
        references.push_back({{vec3(0), vec3(std::exp2(0.05f * float(i) - 50))}, 0});
    }
    return references;
}

struct ReferencesCase {
    const char *name;
    References references;
};

inline std::vector<ReferencesCase> references_cases() {
    return {
        {"one", random_boxes(1, 1, 1)},
        {"one_block", random_boxes(8, 1, 1)},
        {"nine", random_boxes(9, 1, 1)},
        {"eight_of_many_kinds", random_boxes(8, 8, 1)},
        {"one_kind", random_boxes(20'000, 1, 0.02f)},
        {"many_kinds", random_boxes(5'000, 8, 0.05f)},
        {"parallel_and_mixed", random_boxes(100'000, 3, 0.01f)},
        {"identical", References(10'000, {{vec3(1, 2, 3), vec3(2, 3, 4)}, 0})},
        {"identical_points", References(10'000, {{vec3(1, 2, 3), vec3(1, 2, 3)}, 5})},
        {"points", random_boxes(5'000, 2, 0)},
        {"flat", scaled(random_boxes(5'000, 1, 0.02f), {1, 0, 1})},
        {"collinear", scaled(random_boxes(5'000, 1, 0.001f), {1, 0, 0})},
        {"collinear_points", scaled(random_boxes(5'000, 1, 0), {0, -1, 0})},
        {"huge", scaled(random_boxes(5'000, 2, 0.02f), vec3(1e30f))},
        {"largest", scaled(random_boxes(5'000, 1, 0), vec3(FLT_MAX))},
        {"from_end_to_end", References(100, {{vec3(-FLT_MAX), vec3(FLT_MAX)}, 0})},
        {"tiny", scaled(random_boxes(5'000, 1, 0.02f), vec3(1e-37f))},
        {"nest", nest(2'000)},
    };
}

}  // namespace brandung
