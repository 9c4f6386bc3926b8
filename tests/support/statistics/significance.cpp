#include "tests/support/statistics/significance.h"

#include <algorithm>
#include <cmath>

namespace brandung::statistics {

double p_of_smallest(double smallest, std::size_t count) { return -std::expm1(static_cast<double>(count) * std::log1p(-smallest)); }

testing::AssertionResult plausible(const std::vector<double> &p_values) {
    const auto smallest = std::min_element(p_values.begin(), p_values.end());
    const double p = p_of_smallest(*smallest, p_values.size());
    if (p >= significance) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "p-value " << *smallest << " is that of test " << smallest - p_values.begin() << ", the smallest of "
                                       << p_values.size() << ": by chance with probability " << p;
}

}  // namespace brandung::statistics
