#include "tools/converge/report.h"

#include <fmt/format.h>

#include "tools/converge/page.h"

namespace brandung {
namespace {

using nlohmann::json;

json slope_json(const std::optional<Slope> &slope) {
    return slope ? json{{"slope", slope->slope}, {"standard_error", slope->standard_error}} : json();
}

json rungs_json(const Summary &summary) {
    json list = json::array();
    for (const Rung &rung : summary.rungs) {
        json &each = list.emplace_back(json{{"runs", rung.runs}, {"samples", rung.samples}, {"seconds", rung.seconds}, {"errors", json::object()}});
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
    json all = json::object();
    for (const auto &[measure, targets] : summary.targets) {
        all[measure] = json::array();
        for (const Target &target : targets)
            all[measure].push_back({{"error", target.error}, {"seconds", target.seconds ? json(*target.seconds) : json()}});
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
    return slope ? fmt::format("{:.2f} ± {:.2f}", slope->slope, slope->standard_error) : "-";
}

/// In quotation marks where it has a comma.
std::string csv_field(const std::string &text) { return text.find(',') == std::string::npos ? text : "\"" + text + "\""; }

}  // namespace

json convergence_json(const Convergence &convergence) {
    const Subject &subject = convergence.subject;
    json all = {{"scene", subject.scene},
                {"device", subject.device},
                {"width", subject.width},
                {"height", subject.height},
                {"reference", subject.reference},
                {"reference_noise", subject.reference_noise ? json(*subject.reference_noise) : json()},
                {"interrupted", convergence.interrupted()},
                {"runs_done", convergence.runs_done},
                {"runs_total", convergence.runs_total},
                {"measures", followed_measures()},
                {"series", json::array()}};
    for (std::size_t i = 0; i < convergence.series.size(); ++i) {
        const Summary &summary = convergence.summaries[i];
        all["series"].push_back({{"name", convergence.series[i].name},
                                 {"rungs", rungs_json(summary)},
                                 {"fits", fits_json(summary)},
                                 {"targets", targets_json(summary)},
                                 {"efficiency", summary.efficiency},
                                 {"runs", runs_json(convergence.series[i])}});
    }
    return all;
}

std::string convergence_csv(const Convergence &convergence) {
    std::string text = fmt::format("series,rung,seed,samples,seconds,{}\n", fmt::join(followed_measures(), ","));
    for (const Series &series : convergence.series)
        for (const Run &run : series.runs) {
            text += fmt::format("{},{},{},{:g},{:.6g}", csv_field(series.name), run.rung, run.seed, run.samples, run.seconds);
            for (const std::string &measure : followed_measures()) text += fmt::format(",{:.8g}", run.errors.at(measure));
            text += '\n';
        }
    return text;
}

std::string convergence_text(const Convergence &convergence) {
    const Subject &subject = convergence.subject;
    std::string text =
        fmt::format("{}, {} x {} pixels, on {}\nreference: {}", subject.scene, subject.width, subject.height, subject.device, subject.reference);
    if (subject.reference_noise) text += fmt::format(", of noise {:.3g} (relMSE)", *subject.reference_noise);
    if (convergence.interrupted()) text += fmt::format("\ninterrupted: {} of {} runs", convergence.runs_done, convergence.runs_total);
    for (std::size_t i = 0; i < convergence.series.size(); ++i) {
        const Summary &summary = convergence.summaries[i];
        text += fmt::format("\n\n{}\n   samples     seconds         mse      relmse        mape        flip\n", convergence.series[i].name);
        for (const Rung &rung : summary.rungs) {
            text += fmt::format("{:>10.6g}  {:>10.4g}", rung.samples, rung.seconds);
            for (const std::string &measure : followed_measures()) text += fmt::format("  {:>10.4g}", rung.errors.at(measure).mean);
            text += '\n';
        }
        text += fmt::format("relmse falls with time to the power {}, with samples {}; efficiency 1/(mse s) {:.4g}",
                            slope_text(summary.by_seconds.at("relmse")), slope_text(summary.by_samples.at("relmse")), summary.efficiency);
    }
    return text + "\n";
}

std::string convergence_page(const Convergence &convergence) {
    std::string page(converge_page_html());
    const std::string mark = "/*DATA*/null", data = convergence_json(convergence).dump(-1, ' ', true, json::error_handler_t::replace);
    std::string safe;  // a name with </script> must not end the script
    for (const char c : data) safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return page.replace(page.find(mark), mark.size(), safe);
}

}  // namespace brandung
