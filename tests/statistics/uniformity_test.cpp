/// Kolmogorov's test and Šidák's bound.
#include "tests/support/statistics/uniformity.h"

#include <gtest/gtest.h>

#include "tests/statistics/experiments.h"
#include "tests/support/statistics/significance.h"

namespace brandung::statistics {
namespace {

std::vector<double> uniform(std::mt19937 &random, std::size_t count) {
    std::vector<double> numbers(count);
    for (double &x : numbers) x = std::uniform_real_distribution<double>(0, 1)(random);
    return numbers;
}

}  // namespace

/// The bounds for 20 numbers are 0.294 for 5 % and 0.352 for 1 % (tables of the distance). All numbers at the middle of their own twentieth, moved
/// by less than that, are at distance 1 / 40 + shift.
TEST(Uniformity, BoundsAreThoseOfTables) {
    const auto shifted = [](double distance) {
        std::vector<double> numbers;
        for (int i = 0; i < 20; ++i) numbers.push_back(std::min((i + 0.5) / 20 + distance - 0.025, 1.0));
        return uniformity_p(numbers);
    };
    EXPECT_NEAR(shifted(0.294), 0.05, 0.003);
    EXPECT_NEAR(shifted(0.352), 0.01, 0.001);
    EXPECT_EQ(shifted(0.025), 1);
}

TEST(Uniformity, OfUniformNumbersIsUniform) {
    for (const std::size_t count : {10u, 200u}) {
        const auto p_values = repeated(2000, [&](std::mt19937 &random) { return uniformity_p(uniform(random, count)); });
        for (const double level : {0.01, 0.1, 0.5}) EXPECT_NEAR(share_below(level, p_values), level, tolerance(level, 2000)) << count;
    }
}

/// Numbers a tenth too small, or crowded about the middle as p-values are of errors said too large.
TEST(Uniformity, NoticesBiasAndCrowding) {
    const auto scaled = repeated(100, [](std::mt19937 &random) {
        std::vector<double> numbers = uniform(random, 2000);
        for (double &x : numbers) x *= 0.9;
        return uniformity_p(numbers);
    });
    EXPECT_EQ(share_below(1e-4, scaled), 1) << "the distance 0.1 is 4.5 / sqrt(2000)";
    const auto crowded = repeated(100, [](std::mt19937 &random) {
        std::vector<double> numbers = uniform(random, 2000);
        for (double &x : numbers) x = 0.5 + 0.75 * (x - 0.5);
        return uniformity_p(numbers);
    });
    EXPECT_EQ(share_below(1e-4, crowded), 1);
}

/// 1 - (1 - p)^n.
TEST(Significance, OfTheSmallestOfManyIsSidaks) {
    EXPECT_DOUBLE_EQ(p_of_smallest(0.05, 1), 0.05);
    EXPECT_DOUBLE_EQ(p_of_smallest(0.5, 3), 0.875);
    EXPECT_NEAR(p_of_smallest(1e-12, 1000000), 1e-6, 1e-12);
    const auto of_many = repeated(4000, [](std::mt19937 &random) {
        const std::vector<double> p_values = uniform(random, 50);
        return p_of_smallest(*std::min_element(p_values.begin(), p_values.end()), p_values.size());
    });
    EXPECT_NEAR(share_below(0.05, of_many), 0.05, tolerance(0.05, 4000));
}

TEST(Significance, OneBadBlockAmongManyIsNoticed) {
    std::vector<double> p_values(1000, 0.3);
    EXPECT_TRUE(plausible(p_values));
    p_values[77] = 1e-6;
    EXPECT_TRUE(plausible(p_values)) << "one of a thousand is in one case of a thousand";
    p_values[77] = 5e-8;
    EXPECT_FALSE(plausible(p_values));
    EXPECT_NE(std::string(plausible(p_values).message()).find("test 77"), std::string::npos);
    EXPECT_FALSE(plausible(0.0));
}

}  // namespace brandung::statistics
