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

std::vector<std::string> warnings_of_departures(const std::vector<Series> &series, const ReferencePicture &reference) {
    std::vector<std::string> warnings;
    for (const Series &each : series) {
        if (each.departures.empty()) continue;
        warnings.push_back(fmt::format("{} converges to another picture than {}: {}; its errors are that difference too", each.name,
                                       reference.way ? "the reference" : series.front().name, departures_text(each.departures)));
    }
    return warnings;
}

std::optional<std::string> warning_of_cut(const ReferencePicture &reference) {
    std::size_t ones = 0;
    for (const vec3 &pixel : reference.picture.pixels)
        for (int c = 0; c < 3; ++c) {
            if (pixel[c] > 1) return std::nullopt;
            ones += pixel[c] == 1;
        }
    if (ones == 0) return std::nullopt;
    return fmt::format(
        "{}: nothing in this reference is brighter than 1, and {:.2g} % of its values are 1: if it was cut there, as pictures of integers "
        "are, errors are that difference too",
        reference.name, 100.0 * static_cast<double>(ones) / static_cast<double>(3 * reference.picture.pixels.size()));
}

std::vector<std::string> warnings_of_noise(const std::vector<Series> &series, const std::vector<Summary> &summaries,
                                           const ReferencePicture &reference) {
    if (!reference.noise) return {reference.name + ": nothing is known of this reference's own noise, which limits the smallest errors"};
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < series.size(); ++i)
        if (const std::string text = near_reference(series[i].name, summaries[i], *reference.noise); !text.empty()) warnings.push_back(text);
    return warnings;
}

}  // namespace brandung
