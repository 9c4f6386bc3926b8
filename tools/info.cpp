/// brandung info: what a scene contains, and what rendering it will take.
#include <fmt/core.h>

#include "runtime/renderer.h"
#include "scene/formats/format.h"
#include "tools/commands.h"
#include "tools/report.h"

namespace brandung {
namespace {

struct Options {
    std::string scene, device;
    bool as_json = false;
};

nlohmann::json describe(const Options &options) {
    const Scene scene = read_scene(options.scene);
    const CompiledScene compiled = compile(scene);
    Device device = Device::select(options.device);
    const DeviceScene on_device(device, compiled);
    const Film film(device, scene.film.width, scene.film.height);
    const Renderer renderer(device, scene, compiled, on_device, scene.cameras.at(0), {});
    return {{"file", scene.file},
            {"scene", scene_contents(scene, compiled)},
            {"device", device.info().name},
            {"film", {{"width", scene.film.width}, {"height", scene.film.height}, {"spp", scene.film.spp}}},
            {"integrator", scene.integrator.type},
            {"accelerator", compiled.accelerator},
            {"memory", {{"scene_bytes", on_device.bytes()}, {"film_bytes", film.bytes()}, {"wave_bytes", renderer.wave_bytes()}}},
            {"features", explain(scene, compiled, renderer.integrator())},
            {"warnings", scene.warnings}};
}

/// One line per value; what is nested is indented.
void print(const nlohmann::json &value, const std::string &indent) {
    for (const auto &[name, item] : value.items()) {
        if (name == "features") continue;
        if (item.is_object() && item.empty()) continue;
        if (item.is_object()) {
            fmt::print("{}{}\n", indent, name);
            print(item, indent + "  ");
        } else {
            fmt::print("{}{}: {}\n", indent, name, item.is_string() ? item.get<std::string>() : item.dump());
        }
    }
}

}  // namespace

void add_info(CLI::App &app, int &) {
    CLI::App *command = app.add_subcommand("info", "say what a scene contains and what rendering it will take; renders nothing");
    auto options = std::make_shared<Options>();
    command->add_option("scene", options->scene, "scene file")->required();
    command->add_option("--device", options->device, "OpenCL device whose name contains this");
    command->add_flag("--json", options->as_json, "print JSON");
    command->callback([options] {
        const nlohmann::json description = describe(*options);
        if (options->as_json) {
            fmt::print("{}\n", description.dump(2));
        } else {
            print(description, "");
            fmt::print("{}", description["features"].get<std::string>());
        }
    });
}

}  // namespace brandung
