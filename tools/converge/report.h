/// What `brandung converge` gives: text, JSON, CSV, and a page with plots.
#pragma once
#include <nlohmann/json.hpp>

#include "tools/converge/reference.h"
#include "tools/converge/summary.h"

namespace brandung {

/// What was compared with what.
struct Subject {
    std::string scene, scene_hash, device, program, reference;
    uint width, height;
    std::optional<double> reference_noise;  ///< relMSE of the reference itself, where it is known
    std::vector<std::string> set;           ///< settings that were given for all, "KEY=VALUE"
};

struct Convergence {
    Subject subject;
    std::vector<Series> series;
    std::vector<Summary> summaries;             ///< of each
    std::vector<std::string> warnings;          ///< of what makes errors other than they seem
    std::size_t runs_done = 0, runs_total = 0;  ///< of the series that were rendered here

    bool interrupted() const { return runs_done < runs_total; }
};

/// Which series converge to something else than the reference.
std::vector<std::string> warnings_of_departures(const std::vector<Series> &series, const ReferencePicture &reference);
/// If the reference seems to have been cut at 1, as pictures of integers are.
std::optional<std::string> warning_of_cut(const ReferencePicture &reference);
/// Which rungs come near the reference's own noise, or that it is not known.
std::vector<std::string> warnings_of_noise(const std::vector<Series> &series, const std::vector<Summary> &summaries,
                                           const ReferencePicture &reference);
/// Names are a promise.
nlohmann::json convergence_json(const Convergence &convergence);
/// One line per run: series, rung, seed, samples, seconds, each measure, and 1 for runs of rungs near the reference's noise.
std::string convergence_csv(const Convergence &convergence);
std::string convergence_text(const Convergence &convergence);
/// Complete in itself: it loads nothing.
std::string convergence_page(const Convergence &convergence);

}  // namespace brandung
