/// brandung bench: throughput, kernel by kernel.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "tools/bench/accelerators_command.h"
#include "tools/bench/comparison.h"
#include "tools/bench/growth_command.h"
#include "tools/bench/report.h"
#include "tools/bench/traversal_command.h"
#include "tools/bench/volumes_command.h"
#include "tools/commands.h"
#include "tools/interruption.h"
#include "tools/numbers.h"
#include "tools/progress.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

using nlohmann::json;

struct Options : SceneOptions {
    uint runs = 5;
    std::string compared;
    bool as_json = false, quiet = false;
};

int run(const Options &options) {
    const json earlier = options.compared.empty() ? json() : read_earlier_bench(options.compared);
    const Scene scene = read_scene(options);
    ProgressLine progress(options.quiet);
    Job job(scene, options,
            {.on_build = [&](const std::string &file) { progress.say("building " + file); }, .on_built = {}, .on_launch = {}, .on_step = {}});
    if (!earlier.is_null()) check_same_work(bench_subject(job, options.batch), earlier, options.compared);
    handle_interruptions();
    const auto tell = [&](uint run) { progress.say(run == 0 ? "warming up" : fmt::format("run {} of {}", run, options.runs)); };
    const Measurements measurements = measure(job, options.runs, tell, [] { return !is_interrupted(); });
    progress.clear();
    if (measurements.seconds.empty()) {
        fmt::print(stderr, "interrupted: nothing was measured\n");
        return interrupted_status;
    }
    json bench = bench_json(job, options.batch, measurements);
    if (!earlier.is_null()) bench["comparison"] = comparison_json(bench, earlier);
    print_result(options.as_json ? bench.dump(2) + "\n" : bench_text(bench) + (earlier.is_null() ? "" : "\n" + comparison_text(bench)));
    return measurements.interrupted() ? interrupted_status : 0;
}

}  // namespace

void add_bench(CLI::App &app, int &status) {
    CLI::App *command = app.add_subcommand("bench", "measure the throughput of every kernel while a scene is rendered");
    auto options = std::make_shared<Options>();
    add_scene_options(*command, *options);
    add_device_options(*command, *options);
    command->footer(
        "items: what launches were made for; of shadow rays their slots, of which not all need a ray.\n"
        "ns·core: nanoseconds per item, times compute units.\n"
        "B/item: bytes that an item reads and writes in arrays of records; the scene's few materials and lights do not count,\n"
        "and where a kernel searches the scene or a list nothing can be told (-).\n"
        "%copy: of the bytes per second that the device copies at most; operations are not counted: this is the only roof.\n"
        "%launch: waiting / (waiting + running), where waiting is the time in which a launch was queued, the device free, and\n"
        "it had not begun.\n"
        "%wave: items of a launch over those for which its queue has room (-: works on no queue).\n"
        "The rest of a render's seconds is in no kernel: the host's work, transfers, fills of arrays.\n"
        "Example:\n  brandung bench scene.json --json > before.json; brandung bench scene.json --compare before.json");
    command->option_defaults()->group("Bench");
    command->add_option("--runs", options->runs, "renders that are measured, after one to warm up")
        ->check(whole_numbers(1u, 1000u))
        ->capture_default_str();
    command->add_option("--compare", options->compared, "what --json gave before, of the same scene and settings: times per item are compared");
    command->add_flag("--json", options->as_json, "print JSON");
    command->add_flag("--quiet", options->quiet, "no progress");
    add_bench_accelerators(*command, status);
    add_bench_volumes(*command, status);
    add_bench_growth(*command, status);
    add_bench_traversal(*command, status);
    command->get_option("scene")->required(false);  // else a subcommand's name would be the scene
    command->callback([command, options, &status] {
        if (!command->get_subcommands().empty()) return;
        if (options->scene.empty()) throw CLI::RequiredError("scene");
        status = run(*options);
    });
}

}  // namespace brandung
