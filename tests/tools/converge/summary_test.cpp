/// tools/converge: what follows from runs.
#include "tools/converge/summary.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <set>

#include "tools/converge/ladder.h"
#include "tools/converge/report.h"

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
    EXPECT_NEAR(slow.efficiency.value(), 10, 1e-9) << "1 / (0.1 / n * n)";
    EXPECT_FALSE(summarize(series_of(inverse, 1, {1, 2, 3}), round_targets({})).by_samples.at("mse")) << "a rung has no slope";
}

/// Two rungs, two runs each, errors 2 and 1/2 times a line: logarithms are 0 +- log 2 from it. The residuals' sum is 4 (log 2)², over 2 degrees of
/// freedom, and the spread of x 4 (log 2 / 2)² = (log 2)²; the error of the slope is sqrt(2 (log 2)² / (log 2)²).
TEST(ConvergenceSummary, TheErrorOfASlopeFollowsFromItsResiduals) {
    const Summary summary = summarize(series_of(inverse, 2, {2, 0.5}), round_targets({}));
    EXPECT_NEAR(summary.by_samples.at("mse")->slope, -1, 1e-12);
    EXPECT_NEAR(summary.by_samples.at("mse")->standard_error, std::sqrt(2.0), 1e-12);
}

/// One of three runs took a hundred times as long.
TEST(ConvergenceSummary, TimesAreMedians) {
    Series series = series_of(inverse, 5, {1, 1, 1});
    for (std::size_t i = 1; i < series.runs.size(); i += 3) series.runs[i].seconds *= 100;
    const Summary summary = summarize(series, round_targets({}));
    EXPECT_EQ(summary.rungs.at(2).seconds, 4);
    EXPECT_NEAR(summary.by_seconds.at("mse")->slope, -1, 1e-12);
    EXPECT_NEAR(summary.efficiency.value(), 10, 1e-9);
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
    EXPECT_EQ(summary.targets.at("mse")[0].reached, Target::Reached::within);
    EXPECT_EQ(summary.targets.at("mse")[1].reached, Target::Reached::before);
    EXPECT_EQ(summary.targets.at("mse")[2].reached, Target::Reached::not_yet);
}

/// Errors 0.1, 0.05, ... 0.1 / 16, and 0.001 of noise in the reference, which a tenth of only the last is less than: 0.1 * 0.1 / 8 = 0.00125 > 0.001
/// > 0.000625 = 0.1 * 0.1 / 16. MSE of the last is made twice what it should be: no slope must see it.
TEST(ConvergenceSummary, RungsNearTheReferencesNoiseAreMarkedAndNotFitted) {
    Series series = series_of(inverse, 5);
    series.runs.back().errors["mse"] *= 2;
    const Summary summary = summarize(series, round_targets({}), 0.001), unknown = summarize(series, round_targets({}));
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(summary.rungs[i].near_reference, i == 4) << i;
        EXPECT_FALSE(unknown.rungs[i].near_reference);
    }
    EXPECT_TRUE(is_near_reference(summary, series.runs[4]));
    EXPECT_FALSE(is_near_reference(summary, series.runs[3]));
    EXPECT_NEAR(summary.by_samples.at("mse")->slope, -1, 1e-12);
    EXPECT_GT(unknown.by_samples.at("mse")->slope, -0.9);
    EXPECT_NEAR(summary.by_samples.at("mse")->x, std::pow(2, 1.5), 1e-12) << "the geometric mean of 1, 2, 4, 8";
    EXPECT_NEAR(summary.by_samples.at("mse")->y, 0.1 / std::pow(2, 1.5), 1e-12);
}

/// The same noise; the last of 5 rungs, of 0.1 / 16, is near it, and its MSE ten times smaller than it should be. What is 0.1 / n has efficiency 10.
/// 0.007 was reached after 100 / 7 samples, beyond the 8 of the last rung that counts, and 1 before the first.
TEST(ConvergenceSummary, RungsNearTheReferencesNoiseCountForNoTimeNorEfficiency) {
    Series series = series_of(inverse, 5);
    series.runs.back().errors["mse"] /= 10;
    const std::map<std::string, std::vector<double>> targets = {{"mse", {0.03, 0.007, 1.0}}, {"relmse", {}}, {"mape", {}}, {"flip", {}}};
    const Summary summary = summarize(series, targets, 0.001);
    EXPECT_NEAR(summary.efficiency.value(), 10, 1e-9);
    EXPECT_NEAR(summary.targets.at("mse")[0].seconds.value(), 10.0 / 3, 1e-9);
    EXPECT_EQ(summary.targets.at("mse")[1].reached, Target::Reached::not_yet);
    const Summary noisy = summarize(series, targets, 1.0), exact = summarize(series_of([](double) { return 0.0; }, 2), targets);
    EXPECT_FALSE(noisy.efficiency) << "every rung is near";
    EXPECT_EQ(noisy.no_efficiency, "every rung is near the reference's noise");
    for (const Target &target : noisy.targets.at("mse")) EXPECT_EQ(target.reached, Target::Reached::unknown);
    EXPECT_FALSE(exact.efficiency) << "nor is it infinite";
    EXPECT_EQ(exact.no_efficiency, "without error");
}

/// Seeds from 24300 on meet the reference's, 24301, and those from 2^32 - 1 on go round.
TEST(ConvergenceLadder, SeedsAreAllDifferentFromEachOtherAndTheReferences) {
    for (const uint first : {24300u, 0xffffffffu, 0u}) {
        std::set<uint> seeds = {24301u};
        for (uint i = 0; i < 10; ++i) EXPECT_TRUE(seeds.insert(seed_at(first, i, 24301u)).second) << first << " + " << i;
    }
    EXPECT_EQ(seed_at(5, 3, {}), 8u);
}

TEST(ConvergenceWays, DepartWhereSettingsChangeWhatTheyConvergeTo) {
    const Way way{
        "a", {{"sampler", "sobol"}, {"max_depth", "5"}, {"filter", "box"}, {"threshold", "0"}, {"light_samples", "1"}, {"scene_hash", "1"}}, {}};
    const auto departing = [&](const char *setting, const char *value, bool is_cut = false) {
        Way other = way;
        other.settings[setting] = value;
        if (is_cut) other.biased_by["depth limit"] = "";
        return departures(other, way).size();
    };
    EXPECT_EQ(departing("sampler", "independent"), 0u) << "only noise";
    EXPECT_EQ(departing("light_samples", "2"), 0u);
    EXPECT_EQ(departing("light_samples", "0"), 1u);
    EXPECT_EQ(departing("max_depth", "4"), 0u) << "ends no ray";
    EXPECT_EQ(departing("max_depth", "4", true), 1u);
    EXPECT_EQ(departing("threshold", "0.1"), 1u);
    EXPECT_EQ(departing("filter", "tent"), 1u);
    EXPECT_EQ(departing("scene_hash", "2"), 1u) << "a material, say";
    EXPECT_EQ(departing("shadows", "filtered"), 1u);
    Way opaque = way;
    opaque.transmits = false, opaque.settings["shadows"] = "filtered";
    EXPECT_TRUE(departures(opaque, way).empty()) << "nothing is transparent";
}

/// A name with everything that means something in CSV (RFC 4180), and samples of eight digits.
TEST(ConvergenceReport, CsvQuotesNamesAndKeepsSamples) {
    Convergence convergence{.subject = {}, .series = {series_of(inverse, 1)}, .summaries = {}};
    convergence.series[0].name = "a \"b\", c";
    convergence.series[0].runs[0].samples = 16777215;
    convergence.summaries = {summarize(convergence.series[0], round_targets({}))};
    EXPECT_EQ(convergence_csv(convergence),
              "series,rung,seed,samples,seconds,mse,relmse,mape,flip,near_reference_noise\n\"a \"\"b\"\", c\",0,0,16777215,1,0.1,0.1,0.1,0.1,0\n");
}

TEST(ConvergenceVariants, AreAllCombinations) {
    const std::vector<Variant> all = variants({"film.sampler=sobol,independent", "accelerator=none,wide_bvh"});
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[1].name, "sampler=sobol, accelerator=wide_bvh");
    EXPECT_EQ(all[1].settings, (std::vector<std::string>{"film.sampler=sobol", "accelerator=wide_bvh"}));
    EXPECT_EQ(variants({}).size(), 1u);
    EXPECT_TRUE(variants({})[0].settings.empty());
    const std::vector<Variant> lists = variants({"objects.0.center=[1,0,0],[0,1,0]", "objects.1.center=[2,0,0]"});
    ASSERT_EQ(lists.size(), 2u);
    EXPECT_EQ(lists[1].name, "objects.0.center=[0,1,0], objects.1.center=[2,0,0]") << "their last parts are the same";
    for (const char *wrong : {"film.sampler", "=sobol", "film.sampler=", "film.sampler=a,,b"}) EXPECT_THROW(variants({wrong}), CLI::ValidationError);
}

}  // namespace
}  // namespace brandung
