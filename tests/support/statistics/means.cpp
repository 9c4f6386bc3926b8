#include "tests/support/statistics/means.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace brandung::statistics {

Estimate estimate_of(double sum, double squares, double count) {
    const double mean = sum / count, of_one = std::max(squares - sum * mean, 0.0) / (count - 1);
    return {mean, of_one / count, count - 1};
}

Estimate estimate_of(std::span<const double> samples) {
    double sum = 0, squares = 0;
    const double count = static_cast<double>(samples.size());
    for (const double x : samples) sum += x;
    for (const double x : samples) squares += (x - sum / count) * (x - sum / count);
    return {sum / count, squares / (count - 1) / count, count - 1};
}

Estimate mean_of(std::span<const Estimate> estimates) {
    double sum = 0, variance = 0, spread = 0;
    for (const Estimate &estimate : estimates) {
        sum += estimate.mean, variance += estimate.variance;
        spread += estimate.variance * estimate.variance / estimate.degrees;
    }
    const double count = static_cast<double>(estimates.size());
    if (variance == 0) return {.mean = sum / count};
    return {sum / count, variance / (count * count), variance * variance / spread};
}

double p_of_difference(const Estimate &a, const Estimate &b) {
    const double variance = a.variance + b.variance, difference = std::abs(a.mean - b.mean);
    if (variance == 0) return difference == 0 ? 1 : 0;
    const double degrees = variance * variance / (a.variance * a.variance / a.degrees + b.variance * b.variance / b.degrees);
    return 2 * boost::math::cdf(boost::math::complement(boost::math::students_t(degrees), difference / std::sqrt(variance)));
}

}  // namespace brandung::statistics
