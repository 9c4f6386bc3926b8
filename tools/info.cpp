/// brandung info: what a scene contains, and what rendering it will take.
#include <fmt/core.h>

#include "tools/commands.h"
#include "tools/report.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

struct Options : SceneOptions {
    bool as_json = false;
};

nlohmann::json describe(const Options &options) {
    const Scene scene = read_scene(options);
    const Job job(scene, options, nullptr);
    return {{"file", scene.file},
            {"scene", scene_contents(scene, job.compiled)},
            {"device", job.device.info().name},
            {"camera", job.camera.name},
            {"film", {{"width", scene.film.width}, {"height", scene.film.height}, {"spp", scene.film.spp}}},
            {"integrator", scene.integrator.type},
            {"accelerator", job.compiled.accelerator},
            {"memory", memory(job)},
            {"kernels", job.device.kernels()},
            {"features", features(job)},
            {"notes", scene.notes},
            {"warnings", job.compiled.warnings}};
}

/// One line per value; what is nested is indented. Features have a form of their own.
std::string as_text(const nlohmann::json &value, const std::string &indent) {
    std::string text;
    for (const auto &[name, item] : value.items()) {
        if (name == "features") continue;
        if (item.is_object() && item.empty()) continue;
        if (item.is_object())
            text += fmt::format("{}{}\n{}", indent, name, as_text(item, indent + "  "));
        else
            text += fmt::format("{}{}: {}\n", indent, name, item.is_string() ? item.get<std::string>() : item.dump());
    }
    return text;
}

}  // namespace

void add_info(CLI::App &app, int &) {
    CLI::App *command = app.add_subcommand("info", "say what a scene contains and what rendering it will take; renders nothing");
    auto options = std::make_shared<Options>();
    add_scene_options(*command, *options);
    command->add_flag("--json", options->as_json, "print JSON");
    command->callback([options] {
        const nlohmann::json description = describe(*options);
        print_result(options->as_json ? description.dump(2) + "\n" : as_text(description, "") + explain(description["features"]));
    });
}

}  // namespace brandung
