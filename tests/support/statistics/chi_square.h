/// Pearson's test: whether counts in cells are those of a distribution.
#pragma once
#include <cstdint>
#include <span>

namespace brandung::statistics {

struct ChiSquare {
    double statistic, degrees;
    double p;  ///< of a statistic at least as large, if the counts are those of the distribution
};

/// Counts of independent things in cells against what is expected of each, in any unit. So that the statistic is distributed as chi-square, cells are
/// pooled, from the least expected on, until 5 things are expected in each (Cochran 1954; Mitsuba's and pbrt's tests of samplers do the same). p is
/// 0 if there is anything where nothing can be.
ChiSquare chi_square(std::span<const std::uint64_t> counts, std::span<const double> expected);

}  // namespace brandung::statistics
