#include "tools/converge/report.h"

#include <fmt/format.h>

#include <algorithm>

#include "tools/converge/page.h"
#include "tools/page_with_data.h"

namespace brandung {
namespace {

using nlohmann::json;

json slope_json(const std::optional<Slope> &slope) {
    if (!slope) return nullptr;
    return {{"slope", slope->slope}, {"standard_error", slope->standard_error}, {"through", {slope->x, slope->y}}};
}

json rungs_json(const Summary &summary) {
    json list = json::array();
    for (const Rung &rung : summary.rungs) {
        json &each = list.emplace_back(json{{"runs", rung.runs},
                                            {"samples", rung.samples},
                                            {"seconds", rung.seconds},
                                            {"near_reference_noise", rung.near_reference},
                                            {"errors", json::object()}});
        for (const auto &[measure, error] : rung.errors) each["errors"][measure] = {{"mean", error.mean}, {"low", error.low}, {"high", error.high}};
    }
    return list;
}

json fits_json(const Summary &summary) {
    json fits;
    for (const std::string &measure : followed_measures())
        fits[measure] = {{"by_seconds", slope_json(summary.by_seconds.at(measure))}, {"by_samples", slope_json(summary.by_samples.at(measure))}};
    return fits;
}

json targets_json(const Summary &summary) {
    static constexpr const char *reached[] = {"before the first rung", "within the rungs", "not yet", "unknown"};  // by Target::Reached
    json all = json::object();
    for (const auto &[measure, targets] : summary.targets) {
        all[measure] = json::array();
        for (const Target &target : targets)
            all[measure].push_back({{"error", target.error},
                                    {"seconds", target.seconds ? json(*target.seconds) : json()},
                                    {"reached", reached[static_cast<std::size_t>(target.reached)]}});
    }
    return all;
}

json runs_json(const Series &series) {
    json list = json::array();
    for (const Run &run : series.runs) {
        json &each = list.emplace_back(json{{"rung", run.rung}, {"seed", run.seed}, {"samples", run.samples}, {"seconds", run.seconds}});
        for (const auto &[measure, error] : run.errors) each[measure] = error;
    }
    return list;
}

std::string slope_text(const std::optional<Slope> &slope) {
    return slope ? fmt::format("{:.2f} ± {:.2f}", slope->slope, slope->standard_error) : "unknown (from less than three runs, or one rung)";
}

std::string efficiency_text(const Summary &summary) {
    return summary.efficiency ? fmt::format("{:.4g}", *summary.efficiency) : fmt::format("- ({})", summary.no_efficiency);
}

/// What the series depends on beyond its noise, null where another renderer has made it.
json way_json(const Series &series) {
    if (!series.way) return nullptr;
    json biases = json::array(), departures = json::array();
    for (const auto &[name, why] : series.way->biased_by) biases.push_back({{"name", name}, {"why", why}});
    for (const Departure &each : series.departures) departures.push_back({{"setting", each.setting}, {"own", each.own}, {"other", each.other}});
    json settings = series.way->settings;
    for (const char *told_elsewhere : {"seed", "scene_hash"}) settings.erase(told_elsewhere);
    return {{"settings", settings}, {"scene_hash", series.way->settings.at("scene_hash")}, {"biased_by", biases}, {"departures", departures}};
}

/// In quotation marks where it has some, or a comma or the end of a line.
std::string csv_field(const std::string &text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string field = "\"";
    for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
    return field + "\"";
}

/// "0.0123 ± 0.0004", half of the interval of 95 %; without it of a single run.
std::string error_text(const RungMean &error, std::size_t runs) {
    return runs < 2 ? fmt::format("{:.4g}", error.mean) : fmt::format("{:.4g} ± {:.2g}", error.mean, error.high - error.mean);
}

/// A text of that many characters at least, on the right; bytes of UTF-8 that continue a character do not count.
std::string right(const std::string &text, std::size_t width) {
    const auto characters = static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
    return std::string(width - std::min(width, characters), ' ') + text;
}

}  // namespace

json convergence_json(const Convergence &convergence) {
    const Subject &subject = convergence.subject;
    json all = {{"program", subject.program},
                {"scene", subject.scene},
                {"scene_hash", subject.scene_hash},
                {"set", subject.set},
                {"device", subject.device},
                {"width", subject.width},
                {"height", subject.height},
                {"reference", subject.reference},
                {"reference_noise", subject.reference_noise ? json(*subject.reference_noise) : json()},
                {"interrupted", convergence.interrupted()},
                {"runs_done", convergence.runs_done},
                {"runs_total", convergence.runs_total},
                {"warnings", convergence.warnings},
                {"measures", followed_measures()},
                {"series", json::array()}};
    for (std::size_t i = 0; i < convergence.series.size(); ++i) {
        const Summary &summary = convergence.summaries[i];
        all["series"].push_back({{"name", convergence.series[i].name},
                                 {"way", way_json(convergence.series[i])},
                                 {"rungs", rungs_json(summary)},
                                 {"fits", fits_json(summary)},
                                 {"targets", targets_json(summary)},
                                 {"efficiency", summary.efficiency ? json(*summary.efficiency) : json()},
                                 {"no_efficiency", summary.efficiency ? json() : json(summary.no_efficiency)},
                                 {"runs", runs_json(convergence.series[i])}});
    }
    return all;
}

std::string convergence_csv(const Convergence &convergence) {
    std::string text = fmt::format("series,rung,seed,samples,seconds,{},near_reference_noise\n", fmt::join(followed_measures(), ","));
    for (std::size_t i = 0; i < convergence.series.size(); ++i) {
        const Series &series = convergence.series[i];
        for (const Run &run : series.runs) {
            text += fmt::format("{},{},{},{},{:.6g}", csv_field(series.name), run.rung, run.seed, run.samples, run.seconds);
            for (const std::string &measure : followed_measures()) text += fmt::format(",{:.8g}", run.errors.at(measure));
            text += fmt::format(",{}\n", int{is_near_reference(convergence.summaries[i], run)});
        }
    }
    return text;
}

std::string convergence_text(const Convergence &convergence) {
    const Subject &subject = convergence.subject;
    std::string text = fmt::format("{}, {} x {} pixels, on {}, by {}\nreference: {}", subject.scene, subject.width, subject.height, subject.device,
                                   subject.program, subject.reference);
    if (subject.reference_noise) text += fmt::format(", of noise {:.3g} (relMSE)", *subject.reference_noise);
    if (convergence.interrupted()) text += fmt::format("\ninterrupted: {} of {} runs", convergence.runs_done, convergence.runs_total);
    for (std::size_t i = 0; i < convergence.series.size(); ++i) {
        const Summary &summary = convergence.summaries[i];
        text += fmt::format("\n\n{}\n     samples     seconds", convergence.series[i].name);
        for (const std::string &measure : followed_measures()) text += fmt::format("{:>22}", measure);
        text += '\n';
        for (const Rung &rung : summary.rungs) {
            text += rung.samples > 0 ? fmt::format("{:>12.10g}  {:>10.4g}", rung.samples, rung.seconds)
                                     : fmt::format("{:>12}  {:>10.4g}", "-", rung.seconds);
            for (const std::string &measure : followed_measures()) text += right(error_text(rung.errors.at(measure), rung.runs), 22);
            text += rung.near_reference ? " *\n" : "\n";
        }
        text += fmt::format("relmse falls with time to the power {}, with samples {}; efficiency 1/(mse s) {}",
                            slope_text(summary.by_seconds.at("relmse")), slope_text(summary.by_samples.at("relmse")), efficiency_text(summary));
    }
    text +=
        "\n\n± half of the interval of 95 % of a mean of repetitions, of slopes the standard error; seconds are medians; * near the reference's own "
        "noise\n";
    for (const std::string &warning : convergence.warnings) text += "warning: " + warning + "\n";
    return text;
}

std::string convergence_page(const Convergence &convergence) { return page_with_data(converge_page_html(), convergence_json(convergence)); }

}  // namespace brandung
