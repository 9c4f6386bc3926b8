/// brandung bench: throughput, kernel by kernel.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <memory>

#include "scene/error.h"
#include "tools/bench/report.h"
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

json read_old(const std::string &file) {
    std::ifstream in(file);
    if (!in) throw SceneError(file + ": no such file");
    json old = json::parse(in, nullptr, false);
    if (!old.is_object() || !old.contains("kernels") || !old["kernels"].is_array()) throw SceneError(file + ": is not what bench --json gives");
    return old;
}

int run(const Options &options) {
    const json old = options.compared.empty() ? json() : read_old(options.compared);
    const Scene scene = read_scene(options);
    ProgressLine progress(options.quiet);
    Job job(scene, options,
            {.on_build = [&](const std::string &file) { progress.say("building " + file); }, .on_built = {}, .on_launch = {}, .on_step = {}});
    handle_interruptions();
    const Measurements measurements = measure(job, options.runs, [&](uint run) {
        progress.say(run == 0 ? "warming up" : fmt::format("run {} of {}", run, options.runs));
        return !is_interrupted();
    });
    progress.clear();
    if (measurements.seconds.empty() || is_interrupted()) {
        fmt::print(stderr, "interrupted\n");
        return interrupted_status;
    }
    json bench = bench_json(job, options.batch, measurements);
    if (!old.is_null()) bench["comparison"] = comparison_json(bench, old);
    print_result(options.as_json ? bench.dump(2) + "\n" : bench_text(bench) + (old.is_null() ? "" : "\n" + comparison_text(bench)));
    return 0;
}

}  // namespace

void add_bench(CLI::App &app, int &status) {
    CLI::App *command = app.add_subcommand("bench", "measure the throughput of every kernel while a scene is rendered");
    auto options = std::make_shared<Options>();
    add_scene_options(*command, *options);
    add_device_options(*command, *options);
    command->footer(
        "ns·core: nanoseconds per item, times compute units. GB/s: of the records in arrays of which an item has one; what is looked up in the "
        "scene\n"
        "does not count. %copy: of what the device copies at most. %launch: that as many empty launches would take. %wave: of a full batch per "
        "launch.\n"
        "Example:\n  brandung bench scene.json --json > before.json; brandung bench scene.json --compare before.json");
    command->option_defaults()->group("Bench");
    command->add_option("--runs", options->runs, "renders that are measured, after one to warm up")
        ->check(whole_numbers(1u, 1000u))
        ->capture_default_str();
    command->add_option("--compare", options->compared, "what --json gave before: times per item are compared");
    command->add_flag("--json", options->as_json, "print JSON");
    command->add_flag("--quiet", options->quiet, "no progress");
    command->callback([options, &status] { status = run(*options); });
}

}  // namespace brandung
