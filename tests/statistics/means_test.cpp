/// Welch's t-test and the z-test: published values, how often they are wrong, and what they notice.
#include "tests/support/statistics/means.h"

#include <gtest/gtest.h>

#include "tests/statistics/experiments.h"
#include "tests/support/statistics/uniformity.h"

namespace brandung::statistics {
namespace {

std::vector<double> normal(std::mt19937 &random, std::size_t count, double mean, double deviation) {
    std::normal_distribution<double> distribution(mean, deviation);
    std::vector<double> samples(count);
    for (double &x : samples) x = distribution(random);
    return samples;
}

}  // namespace

/// Mean 2.5, squared deviations 5 of 4 samples: 5 / 3 / 4 is the variance of the mean.
TEST(Means, OfSamplesAndOfTheirSumsAreTheSame) {
    for (const Estimate &estimate : {estimate_of(std::vector<double>{1, 2, 3, 4}), estimate_of(10, 30, 4)}) {
        EXPECT_DOUBLE_EQ(estimate.mean, 2.5);
        EXPECT_DOUBLE_EQ(estimate.variance, 5.0 / 12);
        EXPECT_EQ(estimate.degrees, 3);
    }
}

/// Means of one variance have the degrees of all samples; one of which is known exactly adds none.
TEST(Means, OfMeansHaveSatterthwaitesDegrees) {
    const Estimate a{1, 0.5, 9}, b{3, 0.5, 9}, exact{5, 0};
    const Estimate mean = mean_of(std::vector<Estimate>{a, b, exact});
    EXPECT_DOUBLE_EQ(mean.mean, 3);
    EXPECT_DOUBLE_EQ(mean.variance, 1.0 / 9);
    EXPECT_DOUBLE_EQ(mean.degrees, 18);
    EXPECT_EQ(p_of_difference(mean_of(std::vector<Estimate>{exact, exact}), exact), 1);
    EXPECT_EQ(p_of_difference({4}, exact), 0);
}

/// A table of t has 2.262 for 9 degrees, 1.960 for infinitely many, both for 5 %. Two estimates of equal error and 9 degrees have 18: 2.101.
TEST(Means, ProbabilitiesAreThoseOfTables) {
    EXPECT_NEAR(p_of_difference({2.262, 1, 9}, {0}), 0.05, 1e-4);
    EXPECT_NEAR(p_of_difference({-1.96, 1}, {0}), 0.05, 1e-4);
    EXPECT_NEAR(p_of_difference({1.96 * std::sqrt(2.0), 1}, {0, 1}), 0.05, 1e-4) << "a reference with a variance of its own";
    EXPECT_NEAR(p_of_difference({2.101 * std::sqrt(2.0), 1, 9}, {0, 1, 9}), 0.05, 1e-4);
    // Where one error is far greater, only its degrees count.
    EXPECT_NEAR(p_of_difference({2.262, 1, 9}, {0, 1e-6, 1}), 0.05, 1e-4);
}

/// Very unequal errors and few samples: the z-test would fail too often here.
TEST(Means, DifferencesOfWhatIsEqualAreUniform) {
    const auto p_values = repeated(
        4000, [](std::mt19937 &random) { return p_of_difference(estimate_of(normal(random, 6, 1, 1)), estimate_of(normal(random, 20, 1, 3))); });
    for (const double level : {0.01, 0.1, 0.5}) EXPECT_NEAR(share_below(level, p_values), level, tolerance(level, 4000));
    EXPECT_GT(uniformity_p(p_values), 1e-3);
    const auto of_reference = repeated(4000, [](std::mt19937 &random) {
        const double reference = normal(random, 1, 1, 0.2)[0];
        return p_of_difference(estimate_of(normal(random, 50, 1, 1)), {reference, 0.04});
    });
    for (const double level : {0.01, 0.1, 0.5}) EXPECT_NEAR(share_below(level, of_reference), level, tolerance(level, 4000));
}

/// 8 standard errors of the difference are noticed at 10^-4, which is 3.9 of them, but for a chance of 2e-5 per experiment; 1 is noticed at 5 % in
/// 17 % of all cases: 0.1685 + 0.0015 of a normal distribution lie beyond 1.96 - 1 and -1.96 - 1.
TEST(Means, BiasIsNoticed) {
    const auto biased_by = [](double errors) {
        return [errors](std::mt19937 &random) {
            return p_of_difference(estimate_of(normal(random, 200, errors * std::sqrt(2.0 / 200), 1)), estimate_of(normal(random, 200, 0, 1)));
        };
    };
    EXPECT_EQ(share_below(1e-4, repeated(300, biased_by(8))), 1);
    EXPECT_NEAR(share_below(0.05, repeated(4000, biased_by(1))), 0.17, tolerance(0.17, 4000));
}

}  // namespace brandung::statistics
