#include "tools/bench/accelerators_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "scene/accelerators/accelerator.h"
#include "scene/error.h"
#include "tools/bench/accelerators_report.h"
#include "tools/interruption.h"
#include "tools/numbers.h"
#include "tools/progress.h"
#include "tools/provenance.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

using nlohmann::json;

constexpr int different_status = 3;

struct Options : SceneOptions {
    std::vector<std::string> scenes, only;
    uint runs = 5, rays = 0, random = 1000000;
    bool check = false, as_json = false, quiet = false;
};

void add_circumstances(json &all, const Device &device, const Options &options) {
    all.update({{"program", program_version()},
                {"device", device.info().name},
                {"driver", device.info().driver},
                {"compute_units", device.info().compute_units},
                {"batch", options.batch},
                {"runs", options.runs},
                {"checked", options.check}});
}

/// The rows of one scene are added to the list.
void add_scene(json &all, Options options, const std::string &file, ProgressLine &progress) {
    options.scene = file;
    const Scene scene = read_scene(options);
    Job job(scene, options);
    const AcceleratorTrial trial{.accelerators = chosen_accelerators(options.only),
                                 .runs = options.runs,
                                 .batch = options.batch,
                                 .most_rays = options.rays > 0 ? options.rays : SIZE_MAX,
                                 .random_rays = options.check ? options.random : 0u,
                                 .check = options.check,
                                 .tell = [&](const std::string &what) { progress.report(what); },
                                 .goes_on = [] { return !is_interrupted(); }};
    for (const AcceleratorRow &row : try_accelerators(job, trial)) all["accelerators"].push_back(accelerator_json(row));
    add_circumstances(all, job.device, options);
}

int run(const Options &options) {
    chosen_accelerators(options.only);
    ProgressLine progress(options.quiet);
    handle_interruptions();
    json all = {{"accelerators", json::array()}};
    for (const std::string &file : options.scenes)
        if (!is_interrupted()) add_scene(all, options, file, progress);
    progress.clear();
    all["interrupted"] = is_interrupted();
    if (is_interrupted()) fmt::print(stderr, "interrupted: rows are of the rays and rounds until then\n");
    print_result(options.as_json ? all.dump(2) + "\n" : accelerators_text(all["accelerators"]));
    if (is_interrupted()) return interrupted_status;
    for (const json &row : all["accelerators"])
        if (row["different"] != 0u) return different_status;
    return 0;
}

}  // namespace

std::vector<std::string> chosen_accelerators(const std::vector<std::string> &only) {
    std::vector<std::string> names;
    for (const std::string &name : only) {
        if (name == "auto") throw SceneError("--only: auto is a choice among accelerators, and none itself");
        names.emplace_back(find_accelerator(name).name);
    }
    if (only.empty())
        for (const AcceleratorKind &kind : accelerator_kinds()) names.emplace_back(kind.name);
    return names;
}

void add_bench_accelerators(CLI::App &bench, int &status) {
    CLI::App *command = bench.add_subcommand("accelerators", "compare all accelerators on the rays that renders of scenes trace");
    auto options = std::make_shared<Options>();
    command->option_defaults()->group("Scene");
    command->add_option("scenes", options->scenes, "scene files")->required();
    add_scene_settings(*command, *options);
    add_device_options(*command, *options);
    command->footer(
        "The rays are those of the first sample of every pixel, as the scene's integrator begins them: camera rays, secondary (mirrored and\n"
        "refracted) and shadow rays. Each accelerator traces them by the kernels that a render takes.\n"
        "packets: whether it has kernels for packets of coherent rays too: M/s compares structures only where this is the same.\n"
        "build s: building it, once. B/primitive: of nodes, and of blocks with the objects in them, per primitive and instance.\n"
        "tests: primitives that a ray is tested against. steps: nodes or cells that it comes to. Both on average over rays one by one. A render\n"
        "traces coherent rays in packets, which share steps and pass over objects by their boxes: tests times M/s is no rate of tests.\n"
        "M/s: million rays per second of the device's time. trace s: that time for all rays. Times are medians of the rounds, in which\n"
        "accelerators take turns.\n"
        "different: rays whose primitive, instance, t, u or v, or visibility, differ by a bit between the kernels of renders and those that\n"
        "count, or with --check from what `none` finds. The exit status is 3 then.\n"
        "--json has the tests and cells of structures in the words of Havran and Sixta (Ray Tracing News 12(1)) too: N_IT, N_TS, N_ETS, N_EETS;\n"
        "tests_made: with empty lanes of blocks.\n"
        "Example:\n  brandung bench accelerators scene.json --check --rays 100000");
    command->option_defaults()->group("Bench");
    command->add_option("--only", options->only, "names of the accelerators to compare, as wide_bvh,none (default: all)")->delimiter(',');
    command->add_flag("--check", options->check, "compare all that rays meet with what `none` finds, and random rays too");
    command->add_option("--rays", options->rays, "of camera, secondary and shadow rays so many of each at most, evenly spread; 0: all")
        ->check(whole_numbers(0u, 1u << 30))
        ->capture_default_str();
    command->add_option("--random", options->random, "random rays that --check adds")->check(whole_numbers(0u, 1u << 28))->capture_default_str();
    command->add_option("--runs", options->runs, "rounds that are measured")->check(whole_numbers(1u, 1000u))->capture_default_str();
    command->add_flag("--json", options->as_json, "print JSON");
    command->add_flag("--quiet", options->quiet, "no progress");
    command->callback([options, &status] { status = run(*options); });
}

}  // namespace brandung
