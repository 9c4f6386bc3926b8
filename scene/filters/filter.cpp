/// Distributions of filters.
#include "scene/filters/filter.h"

#include <algorithm>
#include <cmath>

namespace brandung {
namespace {

constexpr std::size_t steps = 1 << 16;  ///< of integrals from the centre to the radius

/// Integrals from the centre to x = i / steps, by the trapezoidal rule.
std::vector<double> integrals(double (*value)(double), bool of_magnitude) {
    std::vector<double> sums = {0};
    sums.reserve(steps + 1);
    const auto at = [&](std::size_t i) {
        const double f = value(static_cast<double>(i) / steps);
        return of_magnitude ? std::abs(f) : f;
    };
    for (std::size_t i = 0; i < steps; ++i) sums.push_back(sums.back() + (at(i) + at(i + 1)) / (2 * steps));
    return sums;
}

}  // namespace

FilterParams filter_params(const FilterKind &kind, float radius) {
    const double mass = integrals(kind.value, true).back(), integral = integrals(kind.value, false).back();
    const double norm = mass / integral;
    return {.radius = radius,
            .negative_tail = static_cast<float>((mass - integral) / (2 * mass)),
            .weight = static_cast<uint>(std::lround(norm * norm * (1 << 30)))};
}

std::vector<float> filter_table(const FilterKind &kind, float radius) {
    std::vector<float> table;
    if (!kind.tabulated) return table;
    const std::vector<double> mass = integrals(kind.value, true);
    for (uint i = 0; i <= FILTER_INTERVALS; ++i) {
        const double beyond = 1 - static_cast<double>(i) / FILTER_INTERVALS, within = mass.back() * (1 - beyond * beyond);
        const auto after = std::lower_bound(mass.begin() + 1, mass.end() - 1, within);
        const double x = static_cast<double>(after - mass.begin()) - (*after - within) / (*after - *(after - 1));
        table.push_back(static_cast<float>(radius * std::min(x / steps, 1.0)));
    }
    return table;
}

}  // namespace brandung
