/// Experiments repeated many times with numbers drawn on the host, by which tests of statistics are judged.
#pragma once
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace brandung::statistics {

/// The p-values of `count` experiments.
inline std::vector<double> repeated(std::size_t count, const std::function<double(std::mt19937 &)> &experiment) {
    std::mt19937 random(11);
    std::vector<double> p_values;
    for (std::size_t i = 0; i < count; ++i) p_values.push_back(experiment(random));
    return p_values;
}

/// The share of p-values below `level`.
inline double share_below(double level, const std::vector<double> &p_values) {
    double below = 0;
    for (const double p : p_values) below += p < level;
    return below / static_cast<double>(p_values.size());
}

/// 4 standard deviations of the share of so many experiments that has probability `level`.
inline double tolerance(double level, std::size_t experiments) { return 4 * std::sqrt(level * (1 - level) / static_cast<double>(experiments)); }

}  // namespace brandung::statistics
