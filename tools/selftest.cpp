/// brandung selftest: whether a device may be trusted.
#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "runtime/selftest/selftest.h"
#include "runtime/selftest/trust.h"
#include "tools/commands.h"
#include "tools/interruption.h"
#include "tools/numbers.h"
#include "tools/progress.h"
#include "tools/selftest_report.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

constexpr int not_trusted = 3;  ///< exit status

struct Options {
    std::string device;
    uint threads = 0;
    std::vector<std::string> only;
    double seconds = 0;
    bool as_json = false, quiet = false;
};

std::string names_of_subjects() {
    std::string names;
    for (const SubjectEntry &subject : subjects()) names += (names.empty() ? "" : ", ") + subject.name;
    return names;
}

void check_names(const std::vector<std::string> &only) {
    for (const std::string &name : only)
        if (std::none_of(subjects().begin(), subjects().end(), [&](const SubjectEntry &subject) { return subject.name == name; }))
            throw CLI::ValidationError("--only", "there is no subject '" + name + "', only " + names_of_subjects());
}

int run(const Options &options) {
    check_names(options.only);
    Device device = Device::select(options.device, options.threads);
    ProgressLine progress(options.quiet);
    handle_interruptions();
    const std::vector<SubjectReport> reports = run_selftest(
        device, {.only = options.only,
                 .seconds = options.seconds,
                 .on_round = [&](const std::string &subject, uint round) { progress.say(fmt::format("{}, round {}", subject, round + 1)); },
                 .stop = is_interrupted});
    progress.clear();
    if (const std::string warning = remember(device.info(), reports); !warning.empty()) fmt::print(stderr, "warning: {}\n", warning);
    const Outcome outcome = outcome_of(reports, is_interrupted());
    print_result(options.as_json ? as_json(device.info(), reports, outcome).dump(2) + "\n" : as_text(device.info(), reports, outcome));
    for (const SubjectReport &report : reports)
        if (!report.passed()) fmt::print(stderr, "{} ({}): {}\n", report.subject->name, report.subject->file, report.fault);
    if (is_interrupted()) fmt::print(stderr, "interrupted: what has no inputs was not tried\n");
    if (outcome == Outcome::failed) return not_trusted;
    return is_interrupted() ? interrupted_status : 0;
}

}  // namespace

void add_selftest(CLI::App &app, int &status) {
    CLI::App *command = app.add_subcommand("selftest", "try every device function against extended precision: may the device be trusted?");
    auto options = std::make_shared<Options>();
    command->add_option("--only", options->only, "subjects to try: " + names_of_subjects())->delimiter(',')->expected(1)->take_all();
    command->add_option("--long", options->seconds, "SECONDS for which further inputs are tried after those of a default run")
        ->check(numbers([](double x) { return x >= 0 && x < 1e9; }, "a number of seconds from 0 on", "SECONDS"));
    command->add_flag("--json", options->as_json, "print JSON");
    command->add_flag("--quiet", options->quiet, "no progress");
    command->add_option("--device", options->device, "OpenCL device whose name contains this");
    command->add_option("--threads", options->threads, "compute units to use of a CPU (default: all, as 0)")->check(whole_numbers(0u, 65536u));
    command->footer(
        "The exit status is 3 if a subject fails, and 0 if what was tried passes, which says that the device has passed only after all subjects, on "
        "all "
        "inputs of a default run; brandung devices says what is known. render refuses a device after a failure, with these kernels, driver and "
        "program, "
        "until the same subject passes on as many inputs at least.");
    command->callback([options, &status] { status = run(*options); });
}

}  // namespace brandung
