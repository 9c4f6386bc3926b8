/// brandung converge: error over time.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <memory>
#include <set>

#include "scene/error.h"
#include "scene/formats/limits.h"
#include "scene/image.h"
#include "scene/output.h"
#include "tools/commands.h"
#include "tools/converge/climb.h"
#include "tools/converge/foreign_series.h"
#include "tools/converge/report.h"
#include "tools/distinct_files.h"
#include "tools/interruption.h"
#include "tools/numbers.h"
#include "tools/provenance.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

using Climbers = std::vector<std::unique_ptr<Climber>>;

constexpr uint reference_factor = 16;  ///< samples of an automatic reference over those of the last rung

struct Options : SceneOptions {
    std::string reference, saved_reference, html, csv;
    std::vector<std::string> variations, foreign, reference_settings;
    Rungs rungs;
    uint seeds = 4;
    std::optional<uint> reference_spp;
    bool as_json = false, quiet = false;

    bool renders_reference() const { return reference == "auto"; }
};

void refuse(const std::string &option, const std::string &why) { throw CLI::ValidationError(option, why); }

/// What a ladder sets itself must not be asked for.
void check_settings(const std::string &option, const std::vector<std::string> &settings) {
    for (const std::string &setting : settings)
        for (const auto &[key, why] : {std::pair{"film.spp", "--samples says how many"},
                                       {"film.seed", "--seed says the first"},
                                       {"film.pixel", "samples lie anywhere in their pixels"}})
            if (setting.substr(0, setting.find('=')) == key) refuse(option, fmt::format("{} is the ladder's: {}", key, why));
}

template <class Value> bool rises(const std::vector<Value> &values) {
    return std::adjacent_find(values.begin(), values.end(), std::greater_equal()) == values.end();
}

void check_options(Options &options) {
    if (options.spp) refuse("--spp", "is the ladder's: --samples says how many");
    if (!options.pixel.empty()) refuse("--pixel", "is the ladder's: samples lie anywhere in their pixels");
    check_settings("--set", options.settings), check_settings("--vary", options.variations),
        check_settings("--reference-set", options.reference_settings);
    const Rungs &rungs = options.rungs;
    if (!rises(rungs.samples) || !rises(rungs.seconds)) refuse(rungs.samples.empty() ? "--times" : "--samples", "must rise");
    if (rungs.count() == 0) options.rungs.samples = {1, 2, 4, 8, 16, 32, 64};
    if (options.renders_reference() && rungs.samples.empty() && !options.reference_spp)
        refuse("--reference-spp", "needed for --reference auto with --times");
    if (options.renders_reference()) return;
    if (!options.reference_settings.empty()) refuse("--reference-set", "needs --reference auto");
    if (!options.saved_reference.empty()) refuse("--save-reference", "needs --reference auto");
    if (options.reference_spp) refuse("--reference-spp", "needs --reference auto");
}

void check_files(const Options &options, const Scene &scene) {
    std::vector<std::string> inputs = scene.files;
    if (!options.renders_reference()) inputs.push_back(options.reference);
    DistinctFiles files(inputs);
    for (const auto &[option, file] : {std::pair{"--html", options.html}, {"--csv", options.csv}})
        if (!file.empty()) files.add_output(option, file), check_writable(file);
    const Window window = scene.film.window();
    if (options.saved_reference.empty()) return;
    files.add_output("--save-reference", options.saved_reference);
    check_reference_writable(options.saved_reference, window.width(), window.height());
}

/// "NAME=DIR".
std::pair<std::string, std::string> name_and_folder(const std::string &text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) refuse("--series", "expected NAME=DIR, got '" + text + "'");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

std::vector<ForeignSeries> read_foreign(const Options &options, const std::vector<Variant> &ways, const Window &window) {
    std::set<std::string> names;
    for (const Variant &way : ways)
        if (!names.insert(way.name).second) refuse("--vary", "two series would be called '" + way.name + "'");
    std::vector<ForeignSeries> all;
    for (const std::string &text : options.foreign) {
        const auto [name, folder] = name_and_folder(text);
        if (!names.insert(name).second) refuse("--series", "two series would be called '" + name + "'");
        all.push_back(read_foreign_series(name, folder, window.width(), window.height()));
    }
    return all;
}

ReferencePicture rendered_reference(const Options &options, const Climbers &climbers, Teller &teller) {
    const uint last = options.rungs.samples.empty() ? 0 : options.rungs.samples.back();
    const uint spp = options.reference_spp.value_or(std::min(last, max_samples / reference_factor) * reference_factor);
    if (options.reference_settings.empty()) return render_reference(*climbers.front(), spp, teller);
    Climber climber(options, {fmt::format("{}", fmt::join(options.reference_settings, ", ")), options.reference_settings});
    climber.prepare();
    return render_reference(climber, spp, teller);
}

/// `saved` gets the file to which it was written, if it was.
ReferencePicture find_reference(const Options &options, const Climbers &climbers, Teller &teller, std::string &saved) {
    if (!options.renders_reference()) return read_reference(options.reference);
    ReferencePicture reference = rendered_reference(options, climbers, teller);
    if (!options.saved_reference.empty()) write_reference(options.saved_reference, reference), saved = options.saved_reference;
    return reference;
}

void check_size(const ReferencePicture &reference, const Window &window) {
    if (reference.picture.width != window.width() || reference.picture.height != window.height())
        throw SceneError(fmt::format("{}: has {} x {} pixels, not {} x {}", reference.name, reference.picture.width, reference.picture.height,
                                     window.width(), window.height()));
}

/// Every way must render the part of the picture that the reference, or else the first one, shows.
void check_parts(const Climbers &climbers, const std::string &name, const Way &expected) {
    const std::optional<std::string> part = part_of(expected);
    for (const auto &climber : climbers)
        if (const auto own = part_of(climber->way()); part && own != part)
            throw SceneError(fmt::format("{}: shows pixels {}, but {} those {}", name, *part, climber->name(), *own));
}

/// Of series in the order of their climbers.
void add_ways(const Climbers &climbers, const ReferencePicture &reference, std::vector<Series> &all) {
    for (std::size_t i = 0; i < climbers.size(); ++i) {
        all[i].way = climbers[i]->way();
        all[i].departures = departures(climbers[i]->way(), reference.way ? *reference.way : climbers.front()->way());
    }
}

std::size_t count_runs(const std::vector<Series> &all) {
    std::size_t runs = 0;
    for (const Series &series : all) runs += series.runs.size();
    return runs;
}

/// What is known of the ways and the reference before anything is measured.
std::vector<std::string> early_warnings(const Climbers &climbers, const ReferencePicture &reference) {
    std::vector<Series> expected = series_of(climbers);
    add_ways(climbers, reference, expected);
    std::vector<std::string> warnings = warnings_of_departures(expected, reference);
    if (const auto cut = warning_of_cut(reference)) warnings.push_back(*cut);
    return warnings;
}

/// Climbs, and measures the pictures of other renderers too. Throws Interrupted before the first run has ended.
Convergence measure(const Options &options, const Climbers &climbers, std::vector<ForeignSeries> foreign, const ReferencePicture &reference,
                    Teller &teller) {
    const Job &job = climbers.front()->job();
    const Window window = job.scene.film.window();
    Convergence all{.subject = {job.scene.file, scene_fingerprint(job), job.device.info().name, program_version(), reference.name, window.width(),
                                window.height(), reference.noise, options.settings},
                    .series = climb({options.rungs, options.seeds, options.seed.value_or(1)}, climbers, reference, teller),
                    .summaries = {},
                    .warnings = {},
                    .runs_total = options.rungs.count() * options.seeds * climbers.size()};
    add_ways(climbers, reference, all.series);
    all.runs_done = count_runs(all.series);
    if (all.runs_done == 0) throw Interrupted();
    std::erase_if(all.series, [](const Series &series) { return series.runs.empty(); });
    for (ForeignSeries &each : foreign) all.series.push_back(measured(std::move(each), reference.picture));
    return all;
}

/// What follows from the series. Warnings that were not known before are told.
void conclude(Convergence &all, const ReferencePicture &reference, Teller &teller) {
    const auto targets = round_targets(all.series);
    for (const Series &series : all.series) all.summaries.push_back(summarize(series, targets, reference.noise));
    all.warnings = warnings_of_departures(all.series, reference);
    if (const auto cut = warning_of_cut(reference)) all.warnings.push_back(*cut);
    for (const std::string &warning : warnings_of_noise(all.series, all.summaries, reference)) {
        teller.warn(warning);
        all.warnings.push_back(warning);
    }
}

void write(const Convergence &convergence, const Options &options) {
    if (!options.html.empty()) write_text(options.html, convergence_page(convergence));
    if (!options.csv.empty()) write_text(options.csv, convergence_csv(convergence));
    print_result(options.as_json ? convergence_json(convergence).dump(2) + "\n" : convergence_text(convergence));
}

/// Whether all was measured that was asked for. `saved` gets the file to which the reference was written, if it was.
bool run(Options &options, std::string &saved) {
    check_options(options);
    const std::vector<Variant> ways = variants(options.variations);
    handle_interruptions();
    Teller teller(options.quiet);
    Climbers climbers;
    for (const Variant &way : ways) climbers.push_back(std::make_unique<Climber>(options, way));
    const Scene &scene = climbers.front()->scene();
    const Window window = scene.film.window();
    check_files(options, scene);
    std::vector<ForeignSeries> foreign = read_foreign(options, ways, window);
    for (const auto &climber : climbers) climber->prepare();
    check_parts(climbers, climbers.front()->name(), climbers.front()->way());

    const ReferencePicture reference = find_reference(options, climbers, teller, saved);
    if (reference.way) check_parts(climbers, reference.name, *reference.way);
    check_size(reference, window);
    for (const auto &climber : climbers) warm_up(*climber, teller);
    for (const std::string &warning : early_warnings(climbers, reference)) teller.warn(warning);
    Convergence convergence = measure(options, climbers, std::move(foreign), reference, teller);
    conclude(convergence, reference, teller);
    write(convergence, options);
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
        ->add_option("--reference-set", options->reference_settings,
                     "a setting of --reference auto, as in --set (default: those of the first series). A reference is right only for series that "
                     "converge to the same picture; of others, of other depths say, it is warned")
        ->expected(1)
        ->take_all();
    command->add_option("--save-reference", options->saved_reference,
                        "write --reference auto as an EXR, which --reference takes again, with what it was made from");
    command
        ->add_option(
            "--vary", options->variations,
            "KEY=VALUE,VALUE,...: a series for every value of a setting of the scene file, as in --set, whatever other options say of it; several "
            "options: for every combination")
        ->expected(1)
        ->take_all();
    CLI::Option *samples = command->add_option("--samples", options->rungs.samples, "samples per pixel of the rungs (default: 1,2,4,8,16,32,64)")
                               ->delimiter(',')
                               ->check(whole_numbers(1u, max_samples));
    command->add_option("--times", options->rungs.seconds, "seconds of rendering of the rungs instead")
        ->delimiter(',')
        ->check(numbers([](double x) { return x > 0 && std::isfinite(x); }, "a finite number of seconds above 0", "SECONDS"))
        ->excludes(samples);
    command->add_option("--seeds", options->seeds, "repetitions of each rung, with seeds of their own from --seed on, or 1, the same for all series")
        ->check(whole_numbers(1u, 10000u))
        ->capture_default_str();
    command
        ->add_option("--series", options->foreign,
                     "NAME=DIR: pictures of another renderer, and times.json: [{\"file\": \"a.exr\", \"seconds\": 1.5, \"samples\": 16}, ...]; with "
                     "\"seed\" too, and \"rung\" where neither samples nor seconds tell which pictures are repetitions")
        ->expected(1)
        ->take_all();
    command->add_option("--html", options->html, "write a page with plots");
    command->add_option("--csv", options->csv, "write every run as a line of comma-separated values");
    command->add_flag("--json", options->as_json, "print JSON");
    command->add_flag("--quiet", options->quiet, "no progress");
    command->callback([options, &status] {
        std::string saved;
        try {
            if (run(*options, saved)) return;
        } catch (const Interrupted &) {
            fmt::print(stderr, "interrupted: nothing was measured{}\n", saved.empty() ? "" : "; the reference is written to " + saved);
        }
        status = interrupted_status;
    });
}

}  // namespace brandung
