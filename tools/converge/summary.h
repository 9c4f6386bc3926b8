/// What follows from a series: means with their confidence, how fast errors fall, and what that is worth.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "tools/converge/series.h"

namespace brandung {

/// Of the repetitions of one rung.
struct RungMean {
    double mean, low, high;  ///< bounds of an interval of 95 % by Student's t; equal to the mean of a single run
};
struct Rung {
    std::size_t number;  ///< as Run::rung
    std::size_t runs;
    double samples, seconds;  ///< mean, and median: other work on the machine makes times longer
    std::map<std::string, RungMean> errors;
    bool near_reference = false;  ///< whether the reference's own noise is more than a tenth of its relMSE
};

/// error ~ x^slope, fitted by least squares to the logarithms of all runs but those of rungs near the reference, x being their rung's; the line goes
/// through (x, y).
struct Slope {
    double slope, standard_error, x, y;
};

/// An error, and the seconds that it takes to get there: between rungs by a straight line in logarithms; nothing outside of what was rendered. Rungs
/// near the reference do not count.
struct Target {
    enum class Reached { before, within, not_yet, unknown };  ///< the first rung; the rungs; by the last rung; there is none that counts
    double error;
    std::optional<double> seconds;
    Reached reached;
};

struct Summary {
    std::vector<Rung> rungs;
    std::map<std::string, std::optional<Slope>> by_seconds, by_samples;  ///< nothing of fewer than three such runs, or of one rung
    std::map<std::string, std::vector<Target>> targets;
    std::optional<double>
        efficiency;             ///< 1 / (MSE × seconds) of the last rung that is not near the reference: of independent samples always the same
    std::string no_efficiency;  ///< why there is none
};

/// `targets`: errors to reach, by measure. `reference_noise`: relMSE of the reference, where it is known.
Summary summarize(const Series &series, const std::map<std::string, std::vector<double>> &targets, std::optional<double> reference_noise = {});

bool is_near_reference(const Summary &summary, const Run &run);

/// Powers of ten, and halfway between them, that lie among the errors of some series; by measure.
std::map<std::string, std::vector<double>> round_targets(const std::vector<Series> &all);

}  // namespace brandung
