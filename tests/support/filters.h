/// Reconstruction filters on the host, in double and on another way than the program's.
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "scene/filters/filter.h"
#include "scene/kinds.h"

namespace brandung {

/// f(x) at x [pixels], in any unit; mitchell with its constants B and C written out (Mitchell & Netravali 1988, eq. 8).
inline double filter_value(const std::string &name, double x, double radius) {
    const double t = std::abs(x) / radius;
    if (t > 1) return 0;
    if (name == "box") return 1;
    if (name == "tent") return radius - std::abs(x);
    if (name == "gaussian") return std::exp(-x * x / (2 * radius * radius / 9)) - std::exp(-radius * radius / (2 * radius * radius / 9));
    if (name == "mitchell") {
        const double b = 1 / 3.0, c = 1 / 3.0, y = 2 * t;
        if (y < 1) return (12 - 9 * b - 6 * c) * std::pow(y, 3) + (-18 + 12 * b + 6 * c) * y * y + (6 - 2 * b);
        return (-b - 6 * c) * std::pow(y, 3) + (6 * b + 30 * c) * y * y + (-12 * b - 48 * c) * y + (8 * b + 24 * c);
    }
    double sum = 0;
    const double terms[] = {0.35875, 0.48829, 0.14128, 0.01168};
    for (int k = 0; k < 4; ++k) sum += terms[k] * std::cos(M_PI * k * t);  // symmetric about its middle, where all terms are positive
    return sum;
}

/// The integral of f or |f| from a to b, by Simpson's rule.
inline double filter_integral(const std::string &name, double radius, double a, double b, bool of_magnitude) {
    constexpr int steps = 4000;
    double sum = 0;
    for (int i = 0; i <= steps; ++i) {
        const double f = filter_value(name, a + (b - a) * i / steps, radius);
        sum += (of_magnitude ? std::abs(f) : f) * (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2);
    }
    return sum * (b - a) / (3 * steps);
}

/// ∫|f| / ∫f; cut at half the radius, where mitchell's pieces meet, and at 4/7, where it is 0: 7 y² - 22 y + 16 = 0 has the root 8/7.
inline double filter_norm(const std::string &name, double radius) {
    const double cuts[] = {0, radius / 2, radius * 4 / 7, radius};
    double mass = 0, integral = 0;
    for (int i = 0; i < 3; ++i)
        mass += filter_integral(name, radius, cuts[i], cuts[i + 1], true), integral += filter_integral(name, radius, cuts[i], cuts[i + 1], false);
    return mass / integral;
}

inline uint filter_number(const std::string &name) { return kind_number(filter_kinds(), name); }

inline std::vector<std::string> filter_names() {
    std::vector<std::string> names;
    for (const FilterKind &kind : filter_kinds()) names.emplace_back(kind.name);
    return names;
}

}  // namespace brandung
