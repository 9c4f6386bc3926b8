/// What makes errors other than they seem.
#include <fmt/format.h>

#include "tools/converge/report.h"

namespace brandung {
namespace {

/// "max_depth 2, not 5, filter box, not gaussian"
std::string departures_text(const std::vector<Departure> &departures) {
    std::string text;
    for (const Departure &departure : departures)
        text += (text.empty() ? "" : ", ") + (departure.setting == "scene_hash"
                                                  ? "what is in the scene"
                                                  : fmt::format("{} {}, not {}", departure.setting, departure.own, departure.other));
    return text;
}

std::string near_reference(const std::string &name, const Summary &summary, double noise) {
    std::vector<std::string> samples;
    for (const Rung &rung : summary.rungs)
        if (rung.near_reference) samples.push_back(rung.samples > 0 ? fmt::format("{:.10g}", rung.samples) : fmt::format("{:.3g} s", rung.seconds));
    if (samples.empty()) return "";
    return fmt::format(
        "{}: the reference's own noise, {:.3g}, is more than a tenth of the relMSE of {} samples: these errors are too great, and "
        "neither slope, times nor efficiency are taken from them",
        name, noise, fmt::join(samples, ", "));
}

}  // namespace

std::vector<std::string> warnings_of_departures(const std::vector<Series> &series, const Reference &reference) {
    std::vector<std::string> warnings;
    for (const Series &each : series) {
        if (each.departures.empty()) continue;
        warnings.push_back(fmt::format("{} converges to another picture than {}: {}; its errors are that difference too", each.name,
                                       reference.way ? "the reference" : series.front().name, departures_text(each.departures)));
    }
    return warnings;
}

std::vector<std::string> warnings_of_noise(const std::vector<Series> &series, const std::vector<Summary> &summaries, const Reference &reference) {
    if (!reference.noise) return {reference.name + ": nothing is known of this reference's own noise, which limits the smallest errors"};
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < series.size(); ++i)
        if (const std::string text = near_reference(series[i].name, summaries[i], *reference.noise); !text.empty()) warnings.push_back(text);
    return warnings;
}

}  // namespace brandung
