/// Pearson's test: known values, how often it is wrong, and what it notices.
#include "tests/support/statistics/chi_square.h"

#include <gtest/gtest.h>

#include "tests/statistics/experiments.h"
#include "tests/support/statistics/uniformity.h"

namespace brandung::statistics {
namespace {

/// Counts of so many numbers drawn from cells of these weights.
std::vector<std::uint64_t> draw(std::mt19937 &random, std::size_t count, const std::vector<double> &weights) {
    std::discrete_distribution<std::size_t> cell(weights.begin(), weights.end());
    std::vector<std::uint64_t> counts(weights.size());
    for (std::size_t i = 0; i < count; ++i) ++counts[cell(random)];
    return counts;
}

/// Of a direction's cosine, in 20 cells: what is distributed as the cosine, and what is uniform in solid angle.
std::vector<double> cosine_weights() {
    std::vector<double> weights;
    for (int i = 0; i < 20; ++i) weights.push_back(2 * i + 1);
    return weights;
}

}  // namespace

/// 60 throws of a die: the statistic is the sum of (n - 10)² / 10 = (25 + 4 + 4 + 1 + 0 + 100) / 10, and 11.07 is the bound for 5 % and 5 degrees.
TEST(ChiSquare, OfADieIsThatOfTables) {
    const std::vector<double> fair(6, 1);
    const ChiSquare loaded = chi_square(std::vector<std::uint64_t>{5, 8, 8, 9, 10, 20}, fair);
    EXPECT_NEAR(loaded.statistic, 13.4, 1e-12);
    EXPECT_EQ(loaded.degrees, 5);
    EXPECT_LT(loaded.p, 0.05);
    EXPECT_GT(loaded.p, 0.01) << "15.09 is the bound for 1 %";
    EXPECT_EQ(chi_square(std::vector<std::uint64_t>(6, 10), fair).p, 1);
    // Of two degrees, exp(-x / 2) lies beyond x: 4 + 0 + 4 = 8 over 12.
    EXPECT_NEAR(chi_square(std::vector<std::uint64_t>{10, 12, 14}, std::vector<double>(3, 1)).p, std::exp(-8.0 / 12 / 2), 1e-12);
}

/// 1 + 1 + 3 make one cell, the 6 is one of its own, the 89 another.
TEST(ChiSquare, PoolsCellsOfWhichLittleIsExpected) {
    const ChiSquare pooled = chi_square(std::vector<std::uint64_t>{89, 1, 3, 1, 6}, std::vector<double>{89, 1, 1, 3, 6});
    EXPECT_EQ(pooled.degrees, 2);
    EXPECT_EQ(pooled.statistic, 0) << "1 + 3 + 1 are the 5 that are expected of them";
    const ChiSquare rest = chi_square(std::vector<std::uint64_t>{10, 10, 2}, std::vector<double>{10, 10, 2});
    EXPECT_EQ(rest.degrees, 1) << "the 2 and a 10 make a cell";
    EXPECT_THROW(chi_square(std::vector<std::uint64_t>{3, 4}, std::vector<double>{3, 4}), std::invalid_argument) << "one cell is left";
}

TEST(ChiSquare, WhatCannotBeIsNoChance) {
    EXPECT_EQ(chi_square(std::vector<std::uint64_t>{50, 49, 1}, std::vector<double>{1, 1, 0}).p, 0);
    EXPECT_GT(chi_square(std::vector<std::uint64_t>{51, 49, 0}, std::vector<double>{1, 1, 0}).p, 0.5);
}

/// Also where most cells are pooled.
TEST(ChiSquare, OfWhatHoldsIsUniform) {
    std::vector<double> falling;
    for (int i = 0; i < 40; ++i) falling.push_back(std::exp(-0.3 * i));
    for (const std::vector<double> &weights : {cosine_weights(), falling}) {
        const auto p_values = repeated(2000, [&](std::mt19937 &random) { return chi_square(draw(random, 2000, weights), weights).p; });
        for (const double level : {0.01, 0.1, 0.5}) EXPECT_NEAR(share_below(level, p_values), level, tolerance(level, 2000));
        EXPECT_GT(uniformity_p(p_values), 1e-3);
    }
}

/// The power of the test for errors that renderers make.
TEST(ChiSquare, NoticesWhatIsMissing) {
    const std::vector<double> cosine = cosine_weights(), uniform(20, 1);
    EXPECT_EQ(share_below(1e-4, repeated(100, [&](auto &random) { return chi_square(draw(random, 500, uniform), cosine).p; })), 1) << "the cosine";
    std::vector<double> biased = cosine;
    biased[19] *= 1.05;  // 5 % in the fullest of 20 cells, with 10^6 numbers: 97500 are expected there, 312 their deviation
    EXPECT_EQ(share_below(1e-4, repeated(10, [&](auto &random) { return chi_square(draw(random, 1000000, biased), cosine).p; })), 1);
}

}  // namespace brandung::statistics
