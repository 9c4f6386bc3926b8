/// brandung devices: platforms and devices, and which one would be chosen.
#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "runtime/opencl/device.h"
#include "runtime/selftest/trust.h"
#include "tools/commands.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

std::string text_of(const Trust &trust) {
    switch (trust.outcome) {
        case Outcome::untried:
            return "selftest: never tried";
        case Outcome::incomplete:
            return "selftest: incomplete, a part passed on " + trust.date;
        case Outcome::passed:
            return "selftest: passed on " + trust.date;
        case Outcome::failed:
            return "selftest: FAILED on " + trust.date + ": " + trust.why_not;
    }
    return "";
}

void list_devices(bool as_json) {
    nlohmann::json list = nlohmann::json::array();
    std::string text;
    const auto devices = Device::list();
    std::string warning;
    for (const auto &[info, chosen] : devices) {
        const Trust trust = known_trust(info);
        warning = trust.warning;
        list.push_back({{"platform", info.platform},
                        {"name", info.name},
                        {"version", info.version},
                        {"compute_units", info.compute_units},
                        {"memory_bytes", info.memory},
                        {"unsuitable", info.unsuitable},
                        {"chosen", chosen},
                        {"selftest", {{"verdict", outcome_names[int(trust.outcome)]}, {"date", trust.date}, {"failed", trust.why_not}}}});
        text += fmt::format("{} {} | {} | {} compute units, {} MiB | {}\n", chosen ? "*" : " ", info.name, info.platform, info.compute_units,
                            info.memory >> 20, info.unsuitable.empty() ? text_of(trust) : "cannot be used: it " + info.unsuitable);
    }
    if (!warning.empty()) fmt::print(stderr, "warning: {}\n", warning);
    print_result(as_json ? list.dump(2) + "\n" : text);
    if (devices.empty()) Device::select();  // says why there is none
}

}  // namespace

void add_devices(CLI::App &app, int &) {
    CLI::App *command = app.add_subcommand(
        "devices", "list the OpenCL devices, what brandung selftest has said of each, and, marked, the one that is taken by default");
    auto as_json = std::make_shared<bool>(false);
    command->add_flag("--json", *as_json, "print JSON");
    command->callback([as_json] { list_devices(*as_json); });
}

}  // namespace brandung
