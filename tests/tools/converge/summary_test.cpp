/// tools/converge/summary and variants.
#include "tools/converge/summary.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "tools/converge/ladder.h"

namespace brandung {
namespace {

/// Runs of 1, 2, 4, ... samples of a second each, all of whose errors are `error` of the samples.
Series series_of(double (*error)(double samples), uint rungs, const std::vector<double> &factors = {1}) {
    Series series{"series", {}};
    for (uint rung = 0; rung < rungs; ++rung)
        for (const double factor : factors) {
            const double samples = std::pow(2, rung), value = factor * error(samples);
            series.runs.push_back({rung, 0, samples, samples, {{"mse", value}, {"relmse", value}, {"mape", value}, {"flip", value}}});
        }
    return series;
}

double inverse(double samples) { return 0.1 / samples; }
double inverse_square(double samples) { return 0.1 / (samples * samples); }

TEST(ConvergenceSummary, SlopesAreThoseOfPowers) {
    const Summary slow = summarize(series_of(inverse, 5), round_targets({})), fast = summarize(series_of(inverse_square, 5), round_targets({}));
    EXPECT_NEAR(slow.by_samples.at("relmse")->slope, -1, 1e-12);
    EXPECT_NEAR(slow.by_samples.at("relmse")->standard_error, 0, 1e-7);
    EXPECT_NEAR(fast.by_seconds.at("mse")->slope, -2, 1e-12);
    EXPECT_NEAR(slow.efficiency, 10, 1e-9) << "1 / (0.1 / n * n)";
    EXPECT_FALSE(summarize(series_of(inverse, 1, {1, 2, 3}), round_targets({})).by_samples.at("mse")) << "a rung has no slope";
}

/// Two rungs, two runs each, errors 2 and 1/2 times a line: logarithms are 0 +- log 2 from it. The residuals' sum is 4 (log 2)², over 2 degrees of
/// freedom, and the spread of x 4 (log 2 / 2)² = (log 2)²; the error of the slope is sqrt(2 (log 2)² / (log 2)²).
TEST(ConvergenceSummary, TheErrorOfASlopeFollowsFromItsResiduals) {
    const Summary summary = summarize(series_of(inverse, 2, {2, 0.5}), round_targets({}));
    EXPECT_NEAR(summary.by_samples.at("mse")->slope, -1, 1e-12);
    EXPECT_NEAR(summary.by_samples.at("mse")->standard_error, std::sqrt(2.0), 1e-12);
}

/// Student's t of two degrees of freedom has its 97.5 % at 4.30265; the mean of 1, 2, 3 has standard error 1 / sqrt 3.
TEST(ConvergenceSummary, MeansHaveIntervalsByStudentsT) {
    const Summary summary = summarize(series_of([](double) { return 1.0; }, 1, {1, 2, 3}), round_targets({}));
    const RungMean mean = summary.rungs.at(0).errors.at("flip");
    EXPECT_EQ(mean.mean, 2);
    EXPECT_NEAR(mean.high - mean.mean, 4.30265 / std::sqrt(3.0), 1e-5);
    EXPECT_EQ(mean.low, 0) << "errors are not negative";
    EXPECT_EQ(summary.rungs.at(0).runs, 3u);
    const RungMean single = summarize(series_of(inverse, 1), round_targets({})).rungs.at(0).errors.at("mse");
    EXPECT_EQ(single.low, single.high);
}

/// 0.1 / n is 0.03 after 10/3 samples, of a second each.
TEST(ConvergenceSummary, TimesToErrorsLieBetweenRungs) {
    const Series series = series_of(inverse, 6);
    const auto targets = round_targets({series});
    EXPECT_EQ(targets.at("mse").size(), 2u) << "0.1 / 32 < 0.01, 0.03 < 0.1";
    const Summary summary = summarize(series, {{"mse", {0.03, 1.0, 0.001}}, {"relmse", {}}, {"mape", {}}, {"flip", {}}});
    EXPECT_NEAR(summary.targets.at("mse")[0].seconds.value(), 10.0 / 3, 1e-9);
    EXPECT_FALSE(summary.targets.at("mse")[1].seconds);
    EXPECT_FALSE(summary.targets.at("mse")[2].seconds);
}

TEST(ConvergenceVariants, AreAllCombinations) {
    const std::vector<Variant> all = variants({"film.sampler=sobol,independent", "accelerator=none,wide_bvh"});
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[1].name, "sobol, wide_bvh");
    EXPECT_EQ(all[1].settings, (std::vector<std::string>{"film.sampler=sobol", "accelerator=wide_bvh"}));
    EXPECT_EQ(variants({}).size(), 1u);
    EXPECT_TRUE(variants({})[0].settings.empty());
    for (const char *wrong : {"film.sampler", "=sobol", "film.sampler=", "film.sampler=a,,b"}) EXPECT_THROW(variants({wrong}), CLI::ValidationError);
}

}  // namespace
}  // namespace brandung
