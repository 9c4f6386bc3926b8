#include "tools/selftest_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace brandung {
namespace {

using nlohmann::json;

constexpr const char *row = "{:<25}{:>10}{:>10}{:>10}{:>7}  {:<9}{:>10}{:>10}{:>10}{:>10}{:>9}{:>10}{:>10}\n";

std::string number(double x) { return fmt::format("{:.3g}", x); }
double mean(double sum, std::uint64_t count) { return count ? sum / double(count) : 0; }

std::string errors_cells(const Errors &e, const Errors &rounding, const std::string &name, const SubjectReport *subject) {
    const auto cell = [&](std::uint64_t x) { return subject ? std::to_string(x) : std::string(); };
    const Findings none, &f = subject ? subject->findings : none;
    const bool some = e.well_conditioned > 0, both = rounding.well_conditioned > 0;
    return fmt::format(fmt::runtime(row), subject ? subject->subject->name : "", cell(f.inputs), cell(f.hits), cell(f.ambiguous), cell(f.wrong), name,
                       some ? number(mean(e.sum_ulps, e.well_conditioned)) : "", some ? number(e.max_ulps) : "",
                       some ? number(mean(e.sum_relative, e.well_conditioned)) : "", some ? number(e.max_relative) : "",
                       e.count ? number(e.max_of_bound) : "", both ? number(mean(rounding.sum_ulps, rounding.well_conditioned)) : "",
                       both ? number(rounding.max_ulps) : "");
}

std::string lines_of(const SubjectReport &report) {
    std::string text;
    const SubjectReport *first = &report;
    for (std::size_t i = 0; i < quantities; ++i) {
        const Errors &e = report.findings.errors[i];
        if (e.count == 0) continue;
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
                    {"fault", report.fault},
                    {"rounds", report.rounds},
                    {"seconds", report.seconds},
                    {"inputs", f.inputs},
                    {"hits", f.hits},
                    {"ambiguous", f.ambiguous},
                    {"wrong", f.wrong},
                    {"errors", json::object()}};
    for (std::size_t i = 0; i < quantities; ++i) {
        if (f.errors[i].count == 0) continue;
        json errors = as_json(f.errors[i]);
        errors["max_of_bound"] = f.errors[i].max_of_bound, errors["beyond_bound"] = f.errors[i].beyond;
        if (f.rounding[i].count > 0) errors["rounding"] = as_json(f.rounding[i]);
        subject["errors"][quantity_names[i]] = errors;
    }
    return subject;
}

}  // namespace

bool all_passed(const std::vector<SubjectReport> &reports) {
    return std::all_of(reports.begin(), reports.end(), [](const SubjectReport &report) { return report.passed(); });
}

std::string as_text(const DeviceInfo &device, const std::vector<SubjectReport> &reports) {
    std::string text = fmt::format("{} | {}, driver {}\n\n", device.name, device.platform, device.driver);
    text += fmt::format(fmt::runtime(row), "", "", "", "ambig-", "", "", "mean", "max", "mean", "max", "max of", "rounding", "rounding");
    text += fmt::format(fmt::runtime(row), "subject", "inputs", "hits", "uous", "wrong", "errors of", "ulp", "ulp", "relative", "relative", "bound",
                        "mean ulp", "max ulp");
    double seconds = 0;
    for (const SubjectReport &report : reports) text += lines_of(report), seconds += report.seconds;
    if (!device.doubles) text += "\nno column of rounding: the device has no cl_khr_fp64\n";
    text += fmt::format("\n{} in {:.1f} s\n", all_passed(reports) ? "passed" : "FAILED: results of this device may not be trusted", seconds);
    return text;
}

json as_json(const DeviceInfo &device, const std::vector<SubjectReport> &reports) {
    json all = {{"device", {{"platform", device.platform}, {"name", device.name}, {"driver", device.driver}, {"doubles", device.doubles}}},
                {"passed", all_passed(reports)},
                {"subjects", json::array()}};
    for (const SubjectReport &report : reports) all["subjects"].push_back(as_json(report));
    return all;
}

}  // namespace brandung
