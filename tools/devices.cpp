/// brandung devices: platforms and devices, and which one would be chosen.
#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "runtime/opencl/device.h"
#include "tools/commands.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

void list_devices(bool as_json) {
    nlohmann::json list = nlohmann::json::array();
    std::string text;
    const auto devices = Device::list();
    for (const auto &[info, chosen] : devices) {
        list.push_back({{"platform", info.platform},
                        {"name", info.name},
                        {"version", info.version},
                        {"compute_units", info.compute_units},
                        {"memory_bytes", info.memory},
                        {"unsuitable", info.unsuitable},
                        {"chosen", chosen}});
        text += fmt::format("{} {} | {} | {} compute units, {} MiB{}\n", chosen ? "*" : " ", info.name, info.platform, info.compute_units,
                            info.memory >> 20, info.unsuitable.empty() ? "" : " | cannot be used: it " + info.unsuitable);
    }
    print_result(as_json ? list.dump(2) + "\n" : text);
    if (devices.empty()) Device::select();  // says why there is none
}

}  // namespace

void add_devices(CLI::App &app, int &) {
    CLI::App *command = app.add_subcommand("devices", "list the OpenCL devices; the one that is taken by default is marked");
    auto as_json = std::make_shared<bool>(false);
    command->add_flag("--json", *as_json, "print JSON");
    command->callback([as_json] { list_devices(*as_json); });
}

}  // namespace brandung
