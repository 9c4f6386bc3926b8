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

bool splats(const FilmSettings &film) { return film.splat && filter_kinds()[film.filter].has_radius; }

/// Its centre is half a pixel from the pixel's edges.
int splat_reach(const FilmSettings &film) { return splats(film) ? static_cast<int>(std::ceil(film.filter_radius - 0.5f)) : 0; }

Window sampled_window(const FilmSettings &film) {
    const Window window = film.window();
    const auto reach = static_cast<uint>(splat_reach(film));
    return {window.left - std::min(window.left, reach), window.top - std::min(window.top, reach), std::min(window.right + reach, film.width),
            std::min(window.bottom + reach, film.height)};
}

std::vector<float> filter_values(const FilterKind &kind) {
    std::vector<float> values;
    for (uint i = 0; i <= FILTER_INTERVALS; ++i)
        values.push_back(static_cast<float>(kind.value(static_cast<double>(i) / FILTER_INTERVALS) / kind.value(0)));
    return values;
}

double correlated_pixels(const FilmSettings &film) {
    if (!splats(film)) return 1;
    const double radius = film.filter_radius;
    const auto f = [&](double x) { return std::abs(x) < radius ? filter_kinds()[film.filter].value(std::abs(x) / radius) : 0; };
    const auto overlap = [&](double shift) {
        double sum = 0;
        for (int i = 0; i < 1024; ++i) {
            const double x = radius * ((i + 0.5) / 512 - 1);
            sum += f(x) * f(x - shift);
        }
        return sum;
    };
    double squares = 1;
    for (int shift = 1; shift < 2 * radius; ++shift) squares += 2 * std::pow(overlap(shift) / overlap(0), 2);
    return squares * squares;
}

}  // namespace brandung
