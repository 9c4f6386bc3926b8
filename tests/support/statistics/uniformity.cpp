#include "tests/support/statistics/uniformity.h"

#include <algorithm>
#include <cmath>

namespace brandung::statistics {
namespace {

/// Kolmogorov's distribution, from above. Its terms alternate; below 0.3 it is 1 to five digits.
double beyond(double x) {
    if (x < 0.3) return 1;
    double sum = 0;
    for (int k = 1; k <= 20; ++k) sum += (k % 2 ? 2 : -2) * std::exp(-2 * k * k * x * x);
    return std::clamp(sum, 0.0, 1.0);
}

}  // namespace

double uniformity_p(std::vector<double> numbers) {
    std::sort(numbers.begin(), numbers.end());
    const double n = static_cast<double>(numbers.size());
    double distance = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double below = static_cast<double>(i) / n, above = static_cast<double>(i + 1) / n;
        distance = std::max({distance, numbers[i] - below, above - numbers[i]});
    }
    return beyond((std::sqrt(n) + 0.12 + 0.11 / std::sqrt(n)) * distance);
}

}  // namespace brandung::statistics
