/// When a p-value is too small to be chance.
#pragma once
#include <gtest/gtest.h>

#include <vector>

namespace brandung::statistics {

/// Of a test, or of several that belong together: in one of 10000 cases chance alone fails it. Tests have fixed seeds, so that what has passed goes
/// on to pass until the numbers that it draws change.
inline constexpr double significance = 1e-4;

/// The probability that the smallest of so many independent p-values is at most this one, if all hypotheses hold (Šidák 1967).
double p_of_smallest(double smallest, std::size_t count);

/// Whether the p-values of a family of independent tests, of one at least, may be chance. Says which is the smallest, if not.
testing::AssertionResult plausible(const std::vector<double> &p_values);
inline testing::AssertionResult plausible(double p) { return plausible(std::vector<double>{p}); }

}  // namespace brandung::statistics
