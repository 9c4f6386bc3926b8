/// What `brandung converge` gives: text, JSON, CSV, and a page with plots.
#pragma once
#include <nlohmann/json.hpp>

#include "tools/converge/summary.h"

namespace brandung {

/// What was compared with what.
struct Subject {
    std::string scene, device, reference;
    uint width, height;
    std::optional<double> reference_noise;  ///< relMSE of the reference itself, where it is known
};

struct Convergence {
    Subject subject;
    std::vector<Series> series;
    std::vector<Summary> summaries;             ///< of each
    std::size_t runs_done = 0, runs_total = 0;  ///< of the series that were rendered here

    bool interrupted() const { return runs_done < runs_total; }
};

/// Names are a promise.
nlohmann::json convergence_json(const Convergence &convergence);
/// One line per run: series, rung, seed, samples, seconds, and each measure.
std::string convergence_csv(const Convergence &convergence);
std::string convergence_text(const Convergence &convergence);
/// Complete in itself: it loads nothing.
std::string convergence_page(const Convergence &convergence);

}  // namespace brandung
