/// Means with their errors, and whether two of them are of the same thing.
#pragma once
#include <limits>
#include <span>

namespace brandung::statistics {

/// A mean of independent samples.
struct Estimate {
    double mean = 0;
    double variance = 0;                                       ///< of the mean
    double degrees = std::numeric_limits<double>::infinity();  ///< of freedom of the variance; infinite where that is known
};

/// Of so many samples, at least two, from their sum and the sum of their squares.
Estimate estimate_of(double sum, double squares, double count);
Estimate estimate_of(std::span<const double> samples);

/// The mean of independent means (degrees by Satterthwaite 1946).
Estimate mean_of(std::span<const Estimate> estimates);

/// Probability of a difference at least as large, to either side, if both estimate the same: Welch's t-test (1947), which is the z-test where both
/// variances are known.
double p_of_difference(const Estimate &a, const Estimate &b);

}  // namespace brandung::statistics
