#include "tools/bench/growth_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "scene/output.h"
#include "tools/bench/accelerators_command.h"
#include "tools/bench/growing_scenes.h"
#include "tools/bench/growth_report.h"
#include "tools/bench/page.h"
#include "tools/interruption.h"
#include "tools/job.h"
#include "tools/numbers.h"
#include "tools/page_with_data.h"
#include "tools/progress.h"
#include "tools/provenance.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

using nlohmann::json;

struct Options : SceneOptions {
    std::vector<uint> objects = {1000, 10000, 100000, 1000000};
    std::vector<std::string> scenes = {"spheres"}, only;
    std::string html;
    uint runs = 3, rays = 65536;
    bool as_json = false, quiet = false;
};

int run(const Options &options) {
    ProgressLine progress(options.quiet);
    const GrowthTrial trial{.scenes = options.scenes,
                            .accelerators = chosen_accelerators(options.only),
                            .objects = options.objects,
                            .rays = options.rays,
                            .runs = options.runs,
                            .batch = options.batch,
                            .tell = [&](const std::string &what) { progress.report(what); },
                            .goes_on = [] { return !is_interrupted(); }};
    if (!options.html.empty()) check_writable(options.html);
    Device device = Device::select(options.device, options.threads);
    check_trust(device.info(), options.untrusted_device);
    handle_interruptions();
    json all = growth_json(measure_growth(device, trial));
    progress.clear();
    all.update({{"program", program_version()},
                {"device", device.info().name},
                {"driver", device.info().driver},
                {"compute_units", device.info().compute_units},
                {"batch", options.batch},
                {"runs", options.runs},
                {"interrupted", is_interrupted()}});
    if (is_interrupted()) fmt::print(stderr, "interrupted: rows are those measured until then\n");
    if (!options.html.empty()) write_text(options.html, page_with_data(growth_page_html(), all));
    print_result(options.as_json ? all.dump(2) + "\n" : growth_text(all));
    return is_interrupted() ? interrupted_status : 0;
}

}  // namespace

void add_bench_growth(CLI::App &bench, int &status) {
    CLI::App *command = bench.add_subcommand("growth", "how the work of rays grows with the number of objects, by accelerator");
    auto options = std::make_shared<Options>();
    add_device_options(*command, *options);
    command->footer(
        "Scenes are made in the cube [0, 1]^3, rays are random: closest hits from anywhere in any direction, shadow rays (any) between any points.\n"
        "spheres: of one size, 2 % of the volume. triangles: one mesh. clumped: half of the spheres in a hundredth of the cube's width.\n"
        "build s: building it, once. B/object: of nodes and blocks. N_TS: nodes or cells that a ray for the closest hit comes to; N_IT: objects\n"
        "listed there; tests: those that it is tested against; tests made: with empty lanes of blocks. All on average, ray by ray.\n"
        "ns: nanoseconds of the device per ray, with all its compute units: medians of the rounds, in which accelerators take turns.\n"
        "exponent: p of y ~ objects^p, fitted by least squares to the logarithms of the largest two decades.\n"
        "What takes longer than 20 s to build is left out for more objects. Of none rays x objects is 2^31 at most.\n"
        "Example:\n  brandung bench growth --scene spheres,clumped --objects 1000,10000,100000");
    command->option_defaults()->group("Bench");
    command->add_option("--objects", options->objects, "numbers of objects (default: 1000,10000,100000,1000000)")
        ->delimiter(',')
        ->check(whole_numbers(2u, 1u << 24));
    command->add_option("--scene", options->scenes, "spheres, triangles, clumped (default: spheres)")
        ->delimiter(',')
        ->check(CLI::IsMember(std::vector<std::string>(growing_scene_kinds.begin(), growing_scene_kinds.end())));
    command->add_option("--only", options->only, "names of the accelerators to compare, as wide_bvh,none (default: all)")->delimiter(',');
    command->add_option("--rays", options->rays, "rays of each of the two kinds")->check(whole_numbers(1u, 1u << 24))->capture_default_str();
    command->add_option("--runs", options->runs, "rounds that are measured, after one to warm up")
        ->check(whole_numbers(1u, 1000u))
        ->capture_default_str();
    command->add_option("--html", options->html, "write a page with plots");
    command->add_flag("--json", options->as_json, "print JSON");
    command->add_flag("--quiet", options->quiet, "no progress");
    command->callback([options, &status] { status = run(*options); });
}

}  // namespace brandung
