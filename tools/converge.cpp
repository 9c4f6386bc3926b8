/// brandung converge: error over time.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "scene/error.h"
#include "scene/formats/limits.h"
#include "scene/image.h"
#include "scene/output.h"
#include "tools/commands.h"
#include "tools/converge/foreign_series.h"
#include "tools/converge/ladder.h"
#include "tools/converge/report.h"
#include "tools/distinct_files.h"
#include "tools/interruption.h"
#include "tools/numbers.h"
#include "tools/progress.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

constexpr uint reference_factor = 16;  ///< samples of an automatic reference over those of the last rung
constexpr uint reference_seed = 0x5eedu;

struct Options : SceneOptions {
    std::string reference, html, csv;
    std::vector<std::string> varied, foreign;
    Rungs rungs;
    uint seeds = 4;
    std::optional<uint> reference_spp;
    bool as_json = false, quiet = false;
};

struct Reference {
    Picture picture;
    std::string name;
    std::optional<double> noise;
};

/// Before anything was measured.
struct Interrupted {};

void check_interruption() {
    if (is_interrupted()) throw Interrupted();
}

/// Says what is rendered, and ends a render where the program is interrupted.
class Teller {
public:
    explicit Teller(bool quiet) : quiet_(quiet), line_(quiet) {}
    std::function<bool(const RenderProgress &)> observer(const std::string &what) {
        return [this, what](const RenderProgress &progress) {
            line_.say(fmt::format("{}: {:.0f} %", what, 100 * progress.part));
            return !is_interrupted();
        };
    }
    /// A line that stays.
    void note(const std::string &text) {
        line_.clear();
        if (!quiet_) fmt::print(stderr, "{}\n", text);
    }

private:
    bool quiet_;
    ProgressLine line_;
};

Reference make_reference(const Options &options, Climber &climber, Teller &teller) {
    if (options.reference != "auto") return {read_picture(options.reference), options.reference, {}};
    const uint last = options.rungs.samples.empty() ? 0 : options.rungs.samples.back();
    if (last == 0 && !options.reference_spp) throw CLI::ValidationError("--reference-spp", "needed for --reference auto with --times");
    const uint spp = options.reference_spp.value_or(std::min(last, max_samples / reference_factor) * reference_factor);
    teller.note(fmt::format("reference: {} spp of {}", spp, climber.name()));
    Climber::Result result = climber.render(spp, reference_seed, {}, teller.observer("reference"));
    check_interruption();
    return {std::move(result.picture), fmt::format("{} spp of {}", spp, climber.name()),
            result.noise ? std::optional(result.noise->relmse) : std::nullopt};
}

/// One picture of one way, and its errors; nothing if that is interrupted.
std::optional<Run> run_once(const Options &options, Climber &climber, std::size_t rung, uint seed, const Picture &reference, Teller &teller) {
    const bool by_time = options.rungs.samples.empty();
    const auto observe = teller.observer(
        fmt::format("{}, rung {} of {}, repetition {} of {}", climber.name(), rung + 1, options.rungs.count(), seed + 1, options.seeds));
    const StopRules stop{.error = {}, .seconds = by_time ? std::optional(options.rungs.seconds[rung]) : std::nullopt};
    const uint random = options.seed.value_or(1) + seed + options.seeds * static_cast<uint>(rung);
    const Climber::Result result = climber.render(by_time ? max_samples : options.rungs.samples[rung], random, stop, observe);
    if (is_interrupted()) return std::nullopt;
    return Run{rung, random, result.samples, result.seconds, errors_of(result.picture, reference)};
}

/// Rungs one after another, and on each every way with every seed, so that all share what else the machine does; until the program is interrupted.
std::vector<Series> climb(const Options &options, std::vector<std::unique_ptr<Climber>> &climbers, const Picture &reference, Teller &teller) {
    std::vector<Series> all;
    for (const auto &climber : climbers) all.push_back({climber->name(), {}});
    for (std::size_t rung = 0; rung < options.rungs.count(); ++rung) {
        for (uint seed = 0; seed < options.seeds; ++seed)
            for (std::size_t i = 0; i < climbers.size(); ++i) {
                const std::optional<Run> run = run_once(options, *climbers[i], rung, seed, reference, teller);
                if (!run) return all;
                all[i].runs.push_back(*run);
            }
        teller.note(fmt::format("rung {} of {} is measured", rung + 1, options.rungs.count()));
    }
    return all;
}

void check_files(const Options &options, const Scene &scene) {
    DistinctFiles files(scene.files);
    for (const auto &[option, file] : {std::pair{"--html", options.html}, {"--csv", options.csv}})
        if (!file.empty()) files.add_output(option, file), check_writable(file);
}

/// "NAME=DIR".
std::pair<std::string, std::string> name_and_folder(const std::string &text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) throw CLI::ValidationError("--series", "expected NAME=DIR, got '" + text + "'");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

std::size_t count_runs(const std::vector<Series> &all) {
    std::size_t runs = 0;
    for (const Series &series : all) runs += series.runs.size();
    return runs;
}

/// Whether all was measured that was asked for.
bool run(Options &options) {
    if (!std::is_sorted(options.rungs.samples.begin(), options.rungs.samples.end()) ||
        !std::is_sorted(options.rungs.seconds.begin(), options.rungs.seconds.end()))
        throw CLI::ValidationError(options.rungs.samples.empty() ? "--times" : "--samples", "must rise");
    if (options.rungs.count() == 0) options.rungs.samples = {1, 2, 4, 8, 16, 32, 64};
    const std::vector<Variant> ways = variants(options.varied);
    handle_interruptions();
    Teller teller(options.quiet);
    std::vector<std::unique_ptr<Climber>> climbers;
    for (const Variant &way : ways) climbers.push_back(std::make_unique<Climber>(options, way));
    check_files(options, climbers.front()->scene());
    const Window window = climbers.front()->scene().film.window();

    const Reference reference = make_reference(options, *climbers.front(), teller);
    for (const auto &climber : climbers) {  // kernels are compiled outside of what is timed
        climber->render(2, 0, {}, teller.observer("kernels of " + climber->name()));
        check_interruption();
    }
    Convergence convergence{
        .subject = {options.scene, climbers.front()->job().device.info().name, reference.name, window.width(), window.height(), reference.noise},
        .series = climb(options, climbers, reference.picture, teller),
        .summaries = {},
        .runs_total = options.rungs.count() * options.seeds * climbers.size()};
    convergence.runs_done = count_runs(convergence.series);
    if (convergence.runs_done == 0) throw Interrupted();
    std::erase_if(convergence.series, [](const Series &series) { return series.runs.empty(); });
    for (const std::string &foreign : options.foreign) {
        const auto [name, folder] = name_and_folder(foreign);
        convergence.series.push_back(read_foreign_series(name, folder, reference.picture));
    }
    const auto targets = round_targets(convergence.series);
    for (const Series &series : convergence.series) convergence.summaries.push_back(summarize(series, targets));
    if (!options.html.empty()) write_text(options.html, convergence_page(convergence));
    if (!options.csv.empty()) write_text(options.csv, convergence_csv(convergence));
    print_result(options.as_json ? convergence_json(convergence).dump(2) + "\n" : convergence_text(convergence));
    return !convergence.interrupted();
}

}  // namespace

void add_converge(CLI::App &app, int &status) {
    CLI::App *command = app.add_subcommand("converge", "measure how the error falls with samples and time, for one or several ways of rendering");
    auto options = std::make_shared<Options>();
    add_scene_options(*command, *options);
    add_device_options(*command, *options);
    command->footer(
        "Example:\n  brandung converge scene.json --reference auto --vary film.sampler=sobol,independent --size 256x256 --html page.html");
    command->option_defaults()->group("Convergence");
    command->add_option("--reference", options->reference, "the picture that errors are measured from, or auto: one of many samples")->required();
    command->add_option("--reference-spp", options->reference_spp, "samples of --reference auto (default: 16 times those of the last rung)")
        ->check(whole_numbers(2u, max_samples));
    command
        ->add_option(
            "--vary", options->varied,
            "KEY=VALUE,VALUE,...: a series for every value of a setting of the scene file, as in --set; several options: for every combination")
        ->expected(1)
        ->take_all();
    CLI::Option *samples = command->add_option("--samples", options->rungs.samples, "samples per pixel of the rungs (default: 1,2,4,8,16,32,64)")
                               ->delimiter(',')
                               ->check(whole_numbers(1u, max_samples));
    command->add_option("--times", options->rungs.seconds, "seconds of rendering of the rungs instead")
        ->delimiter(',')
        ->check(numbers([](double x) { return x > 0 && std::isfinite(x); }, "a finite number of seconds above 0", "SECONDS"))
        ->excludes(samples);
    command->add_option("--seeds", options->seeds, "repetitions of each rung, with seeds of their own")
        ->check(whole_numbers(1u, 10000u))
        ->capture_default_str();
    command
        ->add_option("--series", options->foreign,
                     "NAME=DIR: pictures of another renderer, and times.json: [{\"file\": \"a.exr\", \"seconds\": 1.5, \"samples\": 16}, ...]")
        ->expected(1)
        ->take_all();
    command->add_option("--html", options->html, "write a page with plots");
    command->add_option("--csv", options->csv, "write every run as a line of comma-separated values");
    command->add_flag("--json", options->as_json, "print JSON");
    command->add_flag("--quiet", options->quiet, "no progress");
    command->callback([options, &status] {
        try {
            if (run(*options)) return;
        } catch (const Interrupted &) {
            fmt::print(stderr, "interrupted: nothing was measured, and nothing is written\n");
        }
        status = interrupted_status;
    });
}

}  // namespace brandung
