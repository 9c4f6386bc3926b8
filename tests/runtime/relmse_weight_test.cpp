/// runtime/wavefront/relmse_weight: means over mixtures against sums of many points.
#include "runtime/wavefront/relmse_weight.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brandung {
namespace {

double weight(double x) { return 1 / (x * x + 0.01); }

/// Mean of the weights over p = sin² t of density p^(hits + 1/2) (1 - p)^(misses + 1/2), by midpoints; dp = 2 sin t cos t dt.
double by_midpoints(const ValueRange &range, double mean, double samples) {
    const double hits = samples * (mean - range.low) / range.width(), misses = samples - hits;
    constexpr int points = 1 << 17;
    double weights = 0, densities = 0;
    for (int i = 0; i < points; ++i) {
        const double t = (i + 0.5) / points * M_PI / 2, s = std::sin(t), c = std::cos(t);
        const double density = std::exp((2 * hits + 2) * std::log(s) + (2 * misses + 2) * std::log(c));
        densities += density, weights += density * weight(range.low + s * s * range.width());
    }
    return weights / densities;
}

TEST(RelmseWeight, OfMixturesIsTheMeanOverTheShares) {
    for (const ValueRange range : {ValueRange{0, 1}, {0.1, 15}, {0.01, 65000}, {0.3, 2}})
        for (const double share : {0.0, 0.03, 0.5, 1.0})
            for (const double samples : {0.0, 2.0, 7.0, 64.0, 1000.0}) {
                const double mean = range.low + share * range.width(), expected = by_midpoints(range, mean, samples);
                EXPECT_NEAR((Mixture{range, mean, samples}.weight()) / expected, 1, 1e-3)
                    << range.low << ' ' << range.high << ' ' << share << ' ' << samples;
            }
}

/// Of samples 0 and 1 and of samples in the middle of these, by hand; 2 of 8 samples at 1 have the variance 2/8 * 6/8, which is the bound.
TEST(RelmseWeight, SamplesOfTheEndsHaveTheGreatestVariance) {
    EXPECT_TRUE(Mixture::is_of_ends({0, 1}, 0.25, 0.25 * 0.75));
    EXPECT_FALSE(Mixture::is_of_ends({0, 1}, 0.25, 0.25 * 0.75 * 0.49));
    EXPECT_TRUE(Mixture::is_of_ends({0, 1}, 0, 0));
}

/// Two samples miss a share of 1.5 / 5 on average, 1000 one of 1.5 / 1003, which makes 0.022 of 15: 0.01 / (0.01 + 0.022²) is above 1/3.
TEST(RelmseWeight, IsOpenWhereFewSamplesAreFarApart) {
    EXPECT_TRUE((Mixture{{0, 15}, 0, 2}.is_open()));
    EXPECT_FALSE((Mixture{{0, 15}, 0, 1000}.is_open()));
    EXPECT_TRUE((Mixture{{0, 15000}, 0, 1000}.is_open()));
    EXPECT_FALSE((Mixture{{0.5, 0.6}, 0.5, 2}.is_open()));
}

/// Half of w'' = (6 x² - 0.02) / (x² + 0.01)³.
TEST(RelmseWeight, HasItsCurvature) {
    for (const double x : {0.0, 0.05, -0.3, 2.0}) {
        EXPECT_DOUBLE_EQ(RelmseWeight(x).w, weight(x));
        EXPECT_NEAR(RelmseWeight(x).half_curvature, (3 * x * x - 0.01) * std::pow(weight(x), 3), 1e-9 * std::pow(weight(x), 2));
    }
}

TEST(RelmseWeight, IsEven) {
    ValueRange range{0.3, 0.3};
    range.include(-2);
    EXPECT_EQ(range.low, 0.3);
    EXPECT_EQ(range.high, 2);
}

}  // namespace
}  // namespace brandung
