#include "runtime/wavefront/relmse_weight.h"

#include <algorithm>
#include <cmath>

namespace brandung {
namespace {

constexpr double darkest = 0.01;
constexpr double weight_exponent = 1.5;  ///< of shares: 1/2 of the arcsine prior, 1 of the samples' variance

/// Density of Beta(a, b) over the logit u of the share p, u = ln(p / (1 - p)), over that at its mode; `odds`: e^u.
class LogitDensity {
public:
    LogitDensity(double a, double b) : a_(a), sum_(a + b), at_mode_(log_of(mode(), a / b)) {}
    double operator()(double u, double odds) const { return std::exp(log_of(u, odds) - at_mode_); }
    double mode() const { return std::log(a_ / (sum_ - a_)); }

private:
    double log_of(double u, double odds) const { return a_ * u - sum_ * std::log1p(odds); }
    double a_, sum_, at_mode_;
};

}  // namespace

RelmseWeight::RelmseWeight(double x) : w(1 / (x * x + darkest)), half_curvature(w * w * (4 * x * x * w - 1)) {}

void ValueRange::include(double value) { low = std::min(low, std::abs(value)), high = std::max(high, std::abs(value)); }

bool Mixture::is_of_ends(const ValueRange &range, double mean, double variance) { return variance >= (range.high - mean) * (mean - range.low) / 2; }

bool Mixture::is_open() const {
    const double missed = weight_exponent / (samples + 2 * weight_exponent);
    return RelmseWeight(range.low).w > 3 * RelmseWeight(range.low + missed * range.width()).w;
}

/// The trapezoidal rule over the logit, outwards from the mode, converges exponentially: the integrand's poles are far from the axis.
double Mixture::weight() const {
    const double hits = samples * (mean - range.low) / range.width(), a = hits + weight_exponent, b = samples - hits + weight_exponent;
    const LogitDensity density(a, b);
    const double step = 0.75 * std::sqrt(1 / a + 1 / b);  // deviations of the logit
    constexpr double negligible = 1e-4 * darkest;         // no weight is above 1 / darkest
    double weights = 0, densities = 0;
    const auto sum_outwards = [&](double first, double direction) {
        for (double u = first;; u += direction * step) {
            const double odds = std::exp(u), here = density(u, odds), share = odds / (1 + odds);
            densities += here, weights += here * RelmseWeight(range.low + share * range.width()).w;
            if (here < negligible * weights) return;
        }
    };
    sum_outwards(density.mode(), 1);
    sum_outwards(density.mode() - step, -1);
    return weights / densities;
}

}  // namespace brandung
