/// Numbers that directions are chosen by.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "kernels/core/portable.h"
#include "tests/support/scenes.h"

namespace brandung {

inline constexpr float below_one = 0x1.fffffep-1f;

inline std::vector<vec3> random_numbers(std::size_t count) {
    Random random(7);
    std::vector<vec3> numbers(count);
    for (vec3 &x : numbers)
        for (int c = 0; c < 3; ++c) x[c] = std::min(random.uniform(0, 1), below_one);
    return numbers;
}

/// Spread evenly: an additive recurrence by powers of the root of x⁴ = x + 1 (Roberts 2018).
inline std::vector<vec3> even_numbers(std::size_t count) {
    constexpr double root = 1.2207440846057596;
    std::vector<vec3> numbers(count);
    for (std::size_t i = 0; i < count; ++i)
        for (int c = 0; c < 3; ++c) numbers[i][c] = std::min(float(std::fmod(0.5 + double(i + 1) / std::pow(root, c + 1), 1)), below_one);
    return numbers;
}

}  // namespace brandung
