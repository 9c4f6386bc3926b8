/// Whether numbers are uniform in [0, 1], as the p-values of many tests are if all that they test holds.
#pragma once
#include <vector>

namespace brandung::statistics {

/// Probability of a distance at least as large between the distribution of so many independent uniform numbers and the uniform one (Kolmogorov 1933,
/// with the correction for their number by Stephens 1970). Deviations too small for one test each show here.
double uniformity_p(std::vector<double> numbers);

}  // namespace brandung::statistics
