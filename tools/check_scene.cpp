/// brandung check: reads a scene and all that it names, reports, and renders nothing. Needs no OpenCL device.
#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include "runtime/integrators/integrator.h"
#include "tools/commands.h"
#include "tools/progress.h"
#include "tools/report.h"
#include "tools/report_text.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

struct Options : SceneOptions {
    bool as_json = false;
};

std::string as_text(const nlohmann::json &report) {
    return fmt::format("{}: {}\n", report["file"].get<std::string>(), contents_text(report["scene"])) +
           warnings_text(report["warnings"], report["warning_places"]);
}

nlohmann::json report_of(const Options &options) {
    ProgressLine progress(false);
    const Scene scene = read_scene(options, [&](const std::string &file, double part) { progress.show_reading(file, part); });
    chosen_camera(scene, options.camera);
    integrator_of(scene);
    const auto watch = [&](const AcceleratorKind &kind, double part) { progress.show_building(kind, part); };
    const CompiledScene compiled = compile(scene, {.watch = watch, .computes_losses = false});
    return {{"file", scene.file},
            {"scene", scene_contents(scene, compiled)},
            {"warnings", compiled.warnings},
            {"warning_places", compiled.warning_places}};
}

}  // namespace

void add_check(CLI::App &app, int &) {
    CLI::App *command = app.add_subcommand("check", "read a scene and all that it names, and report; renders nothing");
    auto options = std::make_shared<Options>();
    add_scene_options(*command, *options);
    command->add_flag("--json", options->as_json, "print JSON");
    command->callback([options] {
        const nlohmann::json report = report_of(*options);
        print_result(options->as_json ? report.dump(2) + "\n" : as_text(report));
    });
}

}  // namespace brandung
