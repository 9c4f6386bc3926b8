#include "runtime/selftest/selftest.h"

#include <algorithm>

#include "runtime/opencl/seconds_now.h"

namespace brandung {
namespace {

struct Run {
    SubjectReport report;
    std::unique_ptr<Subject> subject;
};

/// What fails to build or to run has failed, too.
void run_round(Device &device, Run &run, const SelfTestOptions &options) {
    SubjectReport &report = run.report;
    const double start = seconds_now();
    options.on_round(report.subject->name, report.rounds);
    try {
        if (!run.subject) run.subject = report.subject->make(device);
        report.findings.add(run.subject->examine(report.rounds++));
        report.fault = report.findings.fault;
    } catch (const Error &error) {
        report.fault = error.what();
    }
    report.seconds += seconds_now() - start;
}

bool is_wanted(const SubjectEntry &subject, const std::vector<std::string> &only) {
    return only.empty() || std::find(only.begin(), only.end(), subject.name) != only.end();
}

}  // namespace

std::vector<SubjectReport> run_selftest(Device &device, const SelfTestOptions &options) {
    std::vector<Run> runs;
    for (const SubjectEntry &subject : subjects())
        if (is_wanted(subject, options.only)) runs.push_back({{.subject = &subject, .findings = {}, .fault = {}}, {}});
    for (Run &run : runs)
        for (uint round = 0; round < run.report.subject->rounds && run.report.passed() && !options.stop(); ++round) run_round(device, run, options);
    const double end = seconds_now() + options.seconds;
    while (seconds_now() < end && !options.stop())
        for (Run &run : runs)
            if (run.report.passed() && !options.stop()) run_round(device, run, options);
    std::vector<SubjectReport> reports;
    for (Run &run : runs) reports.push_back(std::move(run.report));
    return reports;
}

Outcome outcome_of(const std::vector<SubjectReport> &reports, bool interrupted) {
    if (std::any_of(reports.begin(), reports.end(), [](const SubjectReport &report) { return !report.passed(); })) return Outcome::failed;
    const bool all = reports.size() == subjects().size() && std::all_of(reports.begin(), reports.end(), std::mem_fn(&SubjectReport::complete));
    return all && !interrupted ? Outcome::passed : Outcome::incomplete;
}

}  // namespace brandung
