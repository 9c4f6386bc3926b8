/// brandung info: what a scene contains, and what rendering it will take.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "scene/accelerators/accelerator.h"
#include "tools/commands.h"
#include "tools/report.h"
#include "tools/report_text.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

using nlohmann::json;

struct Options : SceneOptions {
    bool as_json = false;
};

std::string text_of(const json &value) { return value.get<std::string>(); }

json describe(const Options &options) {
    const Scene scene = read_scene(options);
    const Job job(scene, options);
    return {{"file", scene.file},
            {"scene", scene_contents(scene, job.compiled)},
            {"device", job.device.info().name},
            {"camera", job.camera.name},
            {"film", {{"width", scene.film.width}, {"height", scene.film.height}, {"spp", scene.film.spp}}},
            {"integrator", scene.integrator.type},
            {"accelerator", job.compiled.accelerator->name},
            {"accelerator_quality", quality(job)},
            {"memory", memory(job)},
            {"kernels", job.device.kernels()},
            {"features", features(job)},
            {"notes", scene.notes},
            {"warnings", job.compiled.warnings},
            {"warning_places", job.compiled.warning_places}};
}

/// What the scene's primitives take.
std::string per_primitive(const json &memory, double count) {
    const auto part = [&](const char *name) { return memory[name].get<double>() / count; };
    if (count == 0) return "";
    return fmt::format("          bytes per primitive: {:.1f} for tracing ({:.1f} of nodes, {:.1f} of blocks), {:.1f} for shading\n",
                       part("node_bytes") + part("block_bytes"), part("node_bytes"), part("block_bytes"), part("shading_bytes"));
}

std::string as_text(const json &description) {
    const json &film = description["film"], &memory = description["memory"];
    std::string text = fmt::format("{}\n  has     {}\n", text_of(description["file"]), contents_text(description["scene"]));
    text += fmt::format("  picture {} x {} pixels, {} spp, camera '{}'\n", film["width"].dump(), film["height"].dump(), film["spp"].dump(),
                        text_of(description["camera"]));
    text += fmt::format("  method  integrator {}, accelerator {}{}, on {}\n", text_of(description["integrator"]), text_of(description["accelerator"]),
                        description["accelerator_quality"] == "high" ? ", quality high" : "", text_of(description["device"]));
    for (const char *part : {"scene", "texture", "film", "wave"})
        text += fmt::format("  memory  {:<8}{}\n", part, bytes_text(memory[std::string(part) + "_bytes"]));
    text += per_primitive(memory, description["scene"]["primitives"]);
    for (const json &note : description["notes"]) text += text_of(note) + "\n";
    return text + warnings_text(description["warnings"], description["warning_places"]) + explain(description["features"]) +
           fmt::format("kernels {}\n", fmt::join(description["kernels"].get<std::vector<std::string>>(), " "));
}

}  // namespace

void add_info(CLI::App &app, int &) {
    CLI::App *command = app.add_subcommand("info", "say what a scene contains and what rendering it will take; renders nothing");
    auto options = std::make_shared<Options>();
    add_scene_options(*command, *options);
    add_device_options(*command, *options);
    command->add_flag("--json", options->as_json, "print JSON");
    command->callback([options] {
        const json description = describe(*options);
        print_result(options->as_json ? description.dump(2) + "\n" : as_text(description));
    });
}

}  // namespace brandung
