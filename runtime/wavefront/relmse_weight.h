/// Weights of relMSE, 1 / (value² + 0.01), where the value is known, and where it is only known to be a mixture.
#pragma once

namespace brandung {

/// w(x) = 1 / (x² + 0.01), and half its second derivative.
struct RelmseWeight {
    explicit RelmseWeight(double x);
    double w, half_curvature;
};

/// What a pixel's value may be, and its neighbours': absolute, since w is even.
struct ValueRange {
    double low, high;
    double width() const { return high - low; }
    void include(double value);
};

/// A pixel that shows the two ends of a range in unknown shares, of which `samples` have the mean `mean` (in the range). The prior of the shares is
/// the arcsine distribution: of a straight edge, seen obliquely, small shares p have a density as 1/√p, since the triangle that it cuts off a
/// pixel's corner grows with the square of its height. Values count by the variance of the samples of such a pixel, p (1 - p).
struct Mixture {
    ValueRange range;
    double mean, samples;

    /// Mean of w over the pixel's values. Relative error below 10^-3.
    double weight() const;
    /// Whether so many samples that are all at the low end leave w open by more than a factor of three, which what they would have missed on average
    /// makes.
    bool is_open() const;
    /// Whether samples of this `mean` and `variance` are of the two ends rather than of values between: the variance is at most
    /// (high - mean) (mean - low), if there are no others (Bhatia and Davis 2000), and half of this at least.
    static bool is_of_ends(const ValueRange &range, double mean, double variance);
};

}  // namespace brandung
