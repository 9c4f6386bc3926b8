#include "tools/converge/summary.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

#include "tools/median.h"

namespace brandung {
namespace {

double mean_of(const std::vector<double> &values) { return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size()); }

RungMean mean_with_confidence(const std::vector<double> &values) {
    const double mean = mean_of(values), n = double(values.size());
    if (values.size() < 2) return {mean, mean, mean};
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    const double half = quantile(boost::math::students_t(n - 1), 0.975) * std::sqrt(squares / (n * (n - 1)));
    return {mean, std::max(mean - half, 0.0), mean + half};
}

/// Rungs by their number, from the first to the last that has runs.
std::map<std::size_t, std::vector<const Run *>> by_rung(const Series &series) {
    std::map<std::size_t, std::vector<const Run *>> rungs;
    for (const Run &run : series.runs) rungs[run.rung].push_back(&run);
    return rungs;
}

template <class Value> std::vector<double> values_of(const std::vector<const Run *> &runs, Value value) {
    std::vector<double> values;
    for (const Run *run : runs) values.push_back(value(*run));
    return values;
}

constexpr double largest_share = 0.1;  ///< of a rung's relMSE that a good reference's noise has

/// Runs without error, or whose rung has no samples or seconds, have no logarithm; rungs near the reference do not count.
std::optional<Slope> slope_of(const Series &series, const std::vector<Rung> &rungs, const std::string &measure, double Rung::*x_of) {
    std::vector<double> x, y;
    for (const Rung &rung : rungs)
        for (const Run &run : series.runs)
            if (run.rung == rung.number && !rung.near_reference && run.errors.at(measure) > 0 && rung.*x_of > 0)
                x.push_back(std::log(rung.*x_of)), y.push_back(std::log(run.errors.at(measure)));
    if (x.size() < 3) return std::nullopt;
    const double x_mean = mean_of(x), y_mean = mean_of(y);
    double xx = 0, xy = 0, residuals = 0;
    for (std::size_t i = 0; i < x.size(); ++i) xx += (x[i] - x_mean) * (x[i] - x_mean), xy += (x[i] - x_mean) * (y[i] - y_mean);
    if (xx == 0) return std::nullopt;
    const double slope = xy / xx;
    for (std::size_t i = 0; i < x.size(); ++i) residuals += std::pow(y[i] - y_mean - slope * (x[i] - x_mean), 2);
    return Slope{slope, std::sqrt(residuals / double(x.size() - 2) / xx), std::exp(x_mean), std::exp(y_mean)};
}

/// The first time at which the means of the rungs are down to `error`.
Target target_of(const std::vector<Rung> &rungs, const std::string &measure, double error) {
    if (rungs.empty()) return {error, {}, Target::Reached::unknown};
    if (rungs.front().errors.at(measure).mean < error) return {error, {}, Target::Reached::before};
    for (std::size_t i = 1; i < rungs.size(); ++i) {
        const double before = rungs[i - 1].errors.at(measure).mean, after = rungs[i].errors.at(measure).mean;
        if (!(before >= error && after <= error)) continue;
        const double part = after <= 0 ? 1 : before > after ? std::log(before / error) / std::log(before / after) : 0;
        return {error, rungs[i - 1].seconds * std::pow(rungs[i].seconds / rungs[i - 1].seconds, part), Target::Reached::within};
    }
    return {error, {}, Target::Reached::not_yet};
}

}  // namespace

Summary summarize(const Series &series, const std::map<std::string, std::vector<double>> &targets, std::optional<double> reference_noise) {
    Summary summary{};
    std::vector<Rung> clear;  // of the reference's noise
    for (const auto &[number, runs] : by_rung(series)) {
        Rung &rung = summary.rungs.emplace_back();
        rung.number = number, rung.runs = runs.size();
        rung.samples = mean_of(values_of(runs, [](const Run &run) { return run.samples; }));
        rung.seconds = median(values_of(runs, [](const Run &run) { return run.seconds; }));
        for (const std::string &measure : followed_measures())
            rung.errors[measure] = mean_with_confidence(values_of(runs, [&](const Run &run) { return run.errors.at(measure); }));
        rung.near_reference = reference_noise && *reference_noise > largest_share * rung.errors.at("relmse").mean;
        if (!rung.near_reference) clear.push_back(rung);
    }
    for (const std::string &measure : followed_measures()) {
        summary.by_seconds[measure] = slope_of(series, summary.rungs, measure, &Rung::seconds);
        summary.by_samples[measure] = slope_of(series, summary.rungs, measure, &Rung::samples);
        for (const double error : targets.at(measure)) summary.targets[measure].push_back(target_of(clear, measure, error));
    }
    if (clear.empty())
        summary.no_efficiency = "every rung is near the reference's noise";
    else if (const Rung &last = clear.back(); last.errors.at("mse").mean > 0)
        summary.efficiency = 1 / (last.errors.at("mse").mean * last.seconds);
    else
        summary.no_efficiency = "without error";
    return summary;
}

bool is_near_reference(const Summary &summary, const Run &run) {
    const auto of_run = [&](const Rung &rung) { return rung.number == run.rung; };
    return std::find_if(summary.rungs.begin(), summary.rungs.end(), of_run)->near_reference;
}

std::map<std::string, std::vector<double>> round_targets(const std::vector<Series> &all) {
    std::map<std::string, std::vector<double>> targets;
    for (const std::string &measure : followed_measures()) {
        double low = HUGE_VAL, high = 0;
        for (const Series &series : all)
            for (const Run &run : series.runs)
                if (const double error = run.errors.at(measure); error > 0) low = std::min(low, error), high = std::max(high, error);
        targets[measure];
        for (int decade = 6; decade >= -12; --decade)
            for (const double digit : {3.0, 1.0})
                if (const double error = digit * std::pow(10.0, decade); error > low && error < high) targets[measure].push_back(error);
    }
    return targets;
}

}  // namespace brandung
