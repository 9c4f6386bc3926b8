#include "tools/selftest_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace brandung {
namespace {

using nlohmann::json;

constexpr const char *row = "{:<25}{:>10}{:>10}{:>10}{:>7}  {:<9}{:>10}{:>10}{:>10}{:>10}{:>9}{:>9}{:>10}{:>10}\n";

std::string number(double x) { return fmt::format("{:.3g}", x); }
double mean(double sum, std::uint64_t count) { return count ? sum / double(count) : 0; }

std::string errors_cells(const Errors &e, const Errors &rounding, const std::string &name, const SubjectReport *subject) {
    const auto cell = [&](std::uint64_t x) { return subject ? std::to_string(x) : std::string(); };
    const Findings none, &f = subject ? subject->findings : none;
    const bool some = e.well_conditioned > 0, both = rounding.well_conditioned > 0;
    return fmt::format(fmt::runtime(row), subject ? subject->subject->name : "", cell(f.inputs), cell(f.hits), cell(f.ambiguous), cell(f.wrong), name,
                       some ? number(mean(e.sum_ulps, e.well_conditioned)) : "", some ? number(e.max_ulps) : "",
                       some ? number(mean(e.sum_relative, e.well_conditioned)) : "", some ? number(e.max_relative) : "",
                       e.count ? number(e.max_of_bound) : "", name.empty() ? "" : std::to_string(e.unknown),
                       both ? number(mean(rounding.sum_ulps, rounding.well_conditioned)) : "", both ? number(rounding.max_ulps) : "");
}

std::string lines_of(const SubjectReport &report) {
    std::string text;
    const SubjectReport *first = &report;
    for (std::size_t i = 0; i < quantities; ++i) {
        const Errors &e = report.findings.errors[i];
        if (e.count + e.unknown == 0) continue;
        text += errors_cells(e, report.findings.rounding[i], quantity_names[i], first);
        first = nullptr;
    }
    return first ? errors_cells({}, {}, "", first) : text;
}

json as_json(const Errors &e) {
    return {{"count", e.count},
            {"well_conditioned", e.well_conditioned},
            {"max_ulps", e.max_ulps},
            {"mean_ulps", mean(e.sum_ulps, e.well_conditioned)},
            {"max_relative", e.max_relative},
            {"mean_relative", mean(e.sum_relative, e.well_conditioned)}};
}

json as_json(const SubjectReport &report) {
    const Findings &f = report.findings;
    json subject = {{"name", report.subject->name},
                    {"kernels", report.subject->file},
                    {"bound", report.subject->bound},
                    {"passed", report.passed()},
                    {"complete", report.complete()},
                    {"fault", report.fault},
                    {"rounds", report.rounds},
                    {"seconds", report.seconds},
                    {"inputs", f.inputs},
                    {"hits", f.hits},
                    {"ambiguous", f.ambiguous},
                    {"wrong", f.wrong},
                    {"errors", json::object()}};
    for (std::size_t i = 0; i < quantities; ++i) {
        if (f.errors[i].count + f.errors[i].unknown == 0) continue;
        json errors = as_json(f.errors[i]);
        errors["max_of_bound"] = f.errors[i].max_of_bound, errors["beyond_bound"] = f.errors[i].beyond, errors["unknown"] = f.errors[i].unknown;
        if (f.rounding[i].count > 0) errors["rounding"] = as_json(f.rounding[i]);
        subject["errors"][quantity_names[i]] = errors;
    }
    return subject;
}

constexpr const char *legend = R"(
inputs     what was tried; hits: those of them that meet something, or test more than that nothing happens
ambiguous  decisions (whether, what or which side) that rounding may turn, as extended precision certifies for that input: either is right
wrong      decisions that are not those of extended precision, though rounding cannot turn them
ulp, relative   errors against extended precision where the input is conditioned well: rounding may do less than 2^-12 of the quantity there
max of bound    the largest error over what rounding may do for that input, of all inputs: above 1 the subject fails
unknown    results not looked at: rounding may do as much there as the quantity is large, or about that
rounding   errors against the same kernels in double: that of these columns which rounding alone explains
)";

/// In words; a part is never said to have passed without saying that it is one.
std::string conclusion(const std::vector<SubjectReport> &reports, Outcome outcome) {
    if (outcome == Outcome::failed) return "FAILED: results of this device may not be trusted";
    if (outcome == Outcome::passed) return "passed";
    const auto complete = std::count_if(reports.begin(), reports.end(), std::mem_fn(&SubjectReport::complete));
    return fmt::format("INCOMPLETE: nothing has failed, of {} subjects {} were tried on all inputs", subjects().size(), complete);
}

}  // namespace

std::string as_text(const DeviceInfo &device, const std::vector<SubjectReport> &reports, Outcome outcome) {
    std::string text = fmt::format("{} | {}, driver {}\n\n", device.name, device.platform, device.driver);
    text += fmt::format(fmt::runtime(row), "", "", "", "ambig-", "", "", "mean", "max", "mean", "max", "max of", "", "rounding", "rounding");
    text += fmt::format(fmt::runtime(row), "subject", "inputs", "hits", "uous", "wrong", "errors of", "ulp", "ulp", "relative", "relative", "bound",
                        "unknown", "mean ulp", "max ulp");
    double seconds = 0;
    for (const SubjectReport &report : reports) text += lines_of(report), seconds += report.seconds;
    text += legend;
    if (!device.doubles) text += "no column of rounding: the device has no cl_khr_fp64\n";
    return text + fmt::format("\n{}, {:.1f} s\n", conclusion(reports, outcome), seconds);
}

json as_json(const DeviceInfo &device, const std::vector<SubjectReport> &reports, Outcome outcome) {
    json all = {{"device", {{"platform", device.platform}, {"name", device.name}, {"driver", device.driver}, {"doubles", device.doubles}}},
                {"passed", outcome == Outcome::passed},
                {"verdict", outcome_names[int(outcome)]},
                {"subjects_of_all", subjects().size()},
                {"subjects", json::array()}};
    for (const SubjectReport &report : reports) all["subjects"].push_back(as_json(report));
    return all;
}

}  // namespace brandung
