#include "tools/bench/traversal_command.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "tools/bench/accelerators_command.h"
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

constexpr int wrong_status = 3;
constexpr uint least_terrain = 5000, most_terrain = 1u << 26;

struct Options : SceneOptions {
    Options() { batch = 262144; }
    std::vector<std::string> scenes, procedural, rays = ray_set_names();
    std::string peer;
    uint runs = 5, builds = 1, side = 1024;
    bool as_json = false, quiet = false;
};

/// "terrain:N"
std::string fault_of_procedural(const std::string &text) {
    const std::string prefix = "terrain:";
    if (!text.starts_with(prefix)) return "must be terrain:N, got '" + text + "'";
    std::string number = text.substr(prefix.size());
    return whole_numbers(least_terrain, most_terrain)(number);
}

BuildQuality quality_named(const std::string &name) {
    return BuildQuality(std::ranges::find(build_quality_names, name) - build_quality_names.begin());
}

Scene procedural_scene(const std::string &text, const Options &options) {
    Scene scene = terrain(static_cast<uint>(std::stoul(text.substr(text.find(':') + 1))));
    scene.film.width = scene.film.height = options.side;
    if (!options.accelerator.empty()) scene.accelerator = options.accelerator;
    if (!options.accelerator_quality.empty()) scene.accelerator_quality = quality_named(options.accelerator_quality);
    return scene;
}

void add_scene(json &all, Device &device, const Scene &scene, const Options &options, ProgressLine &progress) {
    const TraversalTrial trial{.rays = options.rays,
                               .accelerator = scene.accelerator,
                               .camera = options.camera,
                               .embree = options.peer == "embree",
                               .runs = options.runs,
                               .batch = options.batch,
                               .builds = options.builds,
                               .tell = [&](const std::string &what) { progress.report(what); },
                               .goes_on = [] { return !is_interrupted(); }};
    const TraversalResult result = try_traversals(device, scene, trial);
    if (!result.peer_refusal.empty()) {
        progress.clear();
        fmt::print(stderr, "warning: {}: Embree is left out: {}\n", scene.file, result.peer_refusal);
    }
    add_traversal_json(all, result);
}

int run(Options options) {
    if (options.scenes.empty() && options.procedural.empty()) throw CLI::RequiredError("scenes or --procedural");
    if (!options.peer.empty()) EmbreePeer::check_built_in();
    options.size = fmt::format("{0}x{0}", options.side);
    ProgressLine progress(options.quiet);
    Device device = Device::select(options.device, options.threads);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, device.info().compute_units);
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
        if (!is_interrupted()) add_scene(all, device, procedural_scene(text, options), options, progress);
    progress.clear();
    all["interrupted"] = is_interrupted();
    if (is_interrupted()) fmt::print(stderr, "interrupted: rows are of the rays and rounds until then\n");
    print_result(options.as_json ? all.dump(2) + "\n" : traversal_text(all));
    if (is_interrupted()) return interrupted_status;
    const bool is_wrong = std::ranges::any_of(
        all["rows"], [](const json &row) { return row["different"] != 0u || (!row["ours_wrong"].is_null() && row["ours_wrong"] != 0u); });
    return is_wrong ? wrong_status : 0;
}

}  // namespace

void add_bench_traversal(CLI::App &bench, int &status) {
    CLI::App *command = bench.add_subcommand("traversal", "compare the kernels that trace rays with one another and with Embree");
    auto options = std::make_shared<Options>();
    command->footer(
        "The same rays are traced by every variant, which are pairs of a render's kernels, and with --peer embree by these functions of Embree 3:\n"
        "rtcIntersect1, 4, 8 and 16, or rtcOccluded, with its flags for coherent (c) and incoherent (i) rays; not by its functions for streams.\n"
        "camera: through the middles of pixels, in a render's order. diffuse: from what these hit, cosine-distributed; diffuse2: from what diffuse\n"
        "rays hit. shadow: from what camera rays hit to one light (the scene's first point or spot light, else a point above it), whether anything\n"
        "is between. any: whether diffuse rays hit anything, however far. All begin off the surface they leave by 2^-20 of its coordinates, at t = "
        "0.\n"
        "Ours know the number of the primitive that they leave, as in a render, and pass it over; Embree's have nothing of the kind.\n"
        "render: the variant that a render takes for rays of that depth, a shadow ray's being that of the ray that asks.\n"
        "M/s: million rays per second of wall time, in the same batches: of ours from the launch to its end, reading rays and writing hits; of\n"
        "Embree with copying rays into its records and hits out of them. Medians of the rounds, in which all take turns. Both have as many "
        "threads.\n"
        "Embree medium, high: its default scenes, by the quality of the build; robust: with RTC_SCENE_FLAG_ROBUST, quality medium. Of each the\n"
        "fastest of the functions, its name, and our speed over its. Functions that took over twice as long as the fastest in the first round\n"
        "after the one that warms up are measured no more.\n"
        "mismatches: rays that differ from Embree's robust scene in what they hit, or by over 2^-12 in t. All of them, those that differ by over\n"
        "2^-20, and every 16th ray whatever both say, are judged by all primitives in double: wrong is what rounding in float does not explain, as\n"
        "a miss at an edge that two triangles share; ambiguous are mismatches of which neither is wrong.\n"
        "different: rays whose answer is not, to the bit, that of the first variant. The exit status is 3 where that or ours wrong is not 0.\n"
        "Builds: from the scene's shapes, or Embree's buffers of vertices and indices, to what rays are traced by; medians with --builds.\n"
        "kernel: hash of the text of the kernel for this scene. --json has all of it, each function of Embree, and device time too.\n"
        "Example:\n  brandung bench traversal bunny.ply --procedural terrain:100000,terrain:1000000 --peer embree");
    command->option_defaults()->group("Scene");
    command->add_option("scenes", options->scenes, "scene files, or meshes");
    command->add_option("--procedural", options->procedural, "terrain:N, a scene of about N triangles that is made here")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::Validator([](std::string &text) { return fault_of_procedural(text); }, "terrain:N"));
    command
        ->add_option("--accelerator", options->accelerator,
                     fmt::format("{} (default: the scene's, or {})", fmt::join(chosen_accelerators({}), ", "), Scene().accelerator))
        ->check(CLI::IsMember(chosen_accelerators({})));
    command->add_option("--accelerator-quality", options->accelerator_quality, "fast or high (default: the scene's, or fast)")
        ->check(CLI::IsMember(std::vector<std::string>(build_quality_names.begin(), build_quality_names.end())));
    command->add_option("--camera", options->camera, "name of the scene's camera to use (default: the first)");
    add_device_options(*command, *options);
    command->option_defaults()->group("Bench");
    command->add_option("--rays", options->rays, "camera, diffuse, diffuse2, shadow, any (default: all)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(ray_set_names()));
    command->add_option("--size", options->side, "camera rays along each side of the picture")
        ->check(whole_numbers(1u, 8192u))
        ->capture_default_str();
    command->add_option("--peer", options->peer, "embree: trace the same rays by Embree too")->check(CLI::IsMember({"embree"}));
    command->add_option("--runs", options->runs, "rounds that are measured, after one to warm up")
        ->check(whole_numbers(1u, 1000u))
        ->capture_default_str();
    command->add_option("--builds", options->builds, "times that everything is built, in turns, of which medians are shown")
        ->check(whole_numbers(1u, 1000u))
        ->capture_default_str();
    command->add_flag("--json", options->as_json, "print JSON");
    command->add_flag("--quiet", options->quiet, "no progress");
    command->callback([options, &status] { status = run(*options); });
}

}  // namespace brandung
