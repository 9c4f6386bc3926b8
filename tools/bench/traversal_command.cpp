#include "tools/bench/traversal_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "tools/bench/terrain.h"
#include "tools/bench/traversal_report.h"
#include "tools/interruption.h"
#include "tools/job.h"
#include "tools/numbers.h"
#include "tools/progress.h"
#include "tools/provenance.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

using nlohmann::json;

constexpr int different_status = 3;
constexpr uint least_terrain = 1000, most_terrain = 1u << 26;

struct Options : SceneOptions {
    Options() { batch = 262144; }
    std::vector<std::string> scenes, procedural, rays = ray_set_names();
    std::string peer;
    uint runs = 5, side = 1024;
    bool as_json = false, quiet = false;
};

/// "terrain:N"
std::string fault_of_procedural(const std::string &text) {
    const std::string prefix = "terrain:";
    if (!text.starts_with(prefix)) return "must be terrain:N, got '" + text + "'";
    std::string number = text.substr(prefix.size());
    return whole_numbers(least_terrain, most_terrain)(number);
}

Scene procedural_scene(const std::string &text, uint side) {
    Scene scene = terrain(static_cast<uint>(std::stoul(text.substr(text.find(':') + 1))));
    scene.film.width = scene.film.height = side;
    return scene;
}

void add_scene(json &all, Device &device, const Scene &scene, const Options &options, ProgressLine &progress) {
    const TraversalTrial trial{.rays = options.rays,
                               .accelerator = scene.accelerator,
                               .camera = options.camera,
                               .embree = options.peer == "embree",
                               .runs = options.runs,
                               .batch = options.batch,
                               .tell = [&](const std::string &what) { progress.report(what); },
                               .goes_on = [] { return !is_interrupted(); }};
    add_traversal_json(all, try_traversals(device, scene, trial));
}

int run(Options options) {
    if (options.scenes.empty() && options.procedural.empty()) throw CLI::RequiredError("scenes or --procedural");
    if (!options.peer.empty() && !EmbreePeer::is_built_in())
        throw Error("this program was built without Embree: install libembree-dev and build it again");
    options.size = fmt::format("{0}x{0}", options.side);
    ProgressLine progress(options.quiet);
    Device device = Device::select(options.device, options.threads);
    check_trust(device.info(), options.untrusted_device);
    handle_interruptions();
    json all = {{"program", program_version()},   {"device", device.info().name},
                {"driver", device.info().driver}, {"compute_units", device.info().compute_units},
                {"batch", options.batch},         {"runs", options.runs},
                {"scenes", json::array()},        {"rows", json::array()},
                {"embree_rows", json::array()}};
    for (const std::string &file : options.scenes) {
        if (is_interrupted()) break;
        options.scene = file;
        add_scene(all, device, read_scene(options), options, progress);
    }
    for (const std::string &text : options.procedural)
        if (!is_interrupted()) add_scene(all, device, procedural_scene(text, options.side), options, progress);
    progress.clear();
    all["interrupted"] = is_interrupted();
    if (is_interrupted()) fmt::print(stderr, "interrupted: rows are of the rays and rounds until then\n");
    print_result(options.as_json ? all.dump(2) + "\n" : traversal_text(all));
    if (is_interrupted()) return interrupted_status;
    for (const json &row : all["rows"])
        if (row["different"] != 0u) return different_status;
    return 0;
}

}  // namespace

void add_bench_traversal(CLI::App &bench, int &status) {
    CLI::App *command = bench.add_subcommand("traversal", "compare the kernels that trace rays with one another and with Embree");
    auto options = std::make_shared<Options>();
    command->option_defaults()->group("Scene");
    command->add_option("scenes", options->scenes, "scene files");
    command->add_option("--procedural", options->procedural, "terrain:N, a scene of about N triangles that is made here")
        ->delimiter(',')
        ->check(CLI::Validator([](std::string &text) { return fault_of_procedural(text); }, "terrain:N"));
    command->add_option("--accelerator", options->accelerator, "of scene files (default: the scene's)");
    command->add_option("--camera", options->camera, "name of the scene's camera to use (default: the first)");
    add_device_options(*command, *options);
    command->option_defaults()->group("Bench");
    command->add_option("--rays", options->rays, "camera, diffuse, diffuse2, shadow, any (default: all)")
        ->delimiter(',')
        ->check(CLI::IsMember(ray_set_names()));
    command->add_option("--size", options->side, "camera rays along each side of the picture")
        ->check(whole_numbers(1u, 8192u))
        ->capture_default_str();
    command->add_option("--peer", options->peer, "embree: trace the same rays by Embree too")->check(CLI::IsMember({"embree"}));
    command->add_option("--runs", options->runs, "rounds that are measured, after one to warm up")
        ->check(whole_numbers(1u, 1000u))
        ->capture_default_str();
    command->add_flag("--json", options->as_json, "print JSON");
    command->add_flag("--quiet", options->quiet, "no progress");
    command->callback([options, &status] { status = run(*options); });
}

}  // namespace brandung
