/// brandung render: from a scene file to pictures.
#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <algorithm>

#include "runtime/opencl/seconds_now.h"
#include "scene/accelerators/accelerator.h"
#include "scene/error.h"
#include "scene/image.h"
#include "scene/output.h"
#include "tools/commands.h"
#include "tools/interruption.h"
#include "tools/render_messages.h"
#include "tools/render_sequence.h"
#include "tools/report.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

Scene read_with_progress(const RenderCommandOptions &options, ProgressLine &progress) {
    Scene scene = read_scene(options, [&](const std::string &file, double part) { progress.show_reading(file, part); });
    progress.clear();
    return scene;
}

/// AOVs that the scene file asks for are not recorded for pictures without channels.
void leave_out_aovs(const RenderCommandOptions &options, Scene &scene) {
    const std::vector<std::string> &files = options.outputs.files;
    if (scene.film.aovs.empty() || !options.aovs.empty() || std::any_of(files.begin(), files.end(), stores_channels)) return;
    scene.film.aovs.clear();
    scene.notes.push_back("film.aovs: not recorded, since no output is an EXR, which alone has channels for them");
}

/// Not after a render of hours.
void check_files(const RenderCommandOptions &options, const Scene &scene) {
    check_distinct(options, scene);
    for (uint picture = 0; picture < options.pictures(); ++picture) check_outputs(options.outputs_of(picture), scene.film);
    for (const std::string &file : {options.stats, options.trace})
        if (!file.empty()) check_writable(file);
}

/// The preview and the trace look at what a job does, where there are any.
JobWatch watch_of(Preview &preview, std::optional<Trace> &trace, ProgressLine &progress, const std::function<void(const std::string &)> &say) {
    JobWatch watch{.on_build = [&say](const std::string &file) { say("building " + file); }, .on_built = {}, .on_launch = {}, .on_step = {}};
    watch.on_trial = [&say](const AcceleratorKind &kind) { say(fmt::format("trying the accelerator {}", kind.name)); };
    watch.on_accelerator = [&progress](const AcceleratorKind &kind, double part) { progress.show_building(kind, part); };
    if (trace) {
        watch.on_built = [&trace](const Build &build) { trace->add(build); };
        watch.on_launch = [&trace](const Launch &launch) { trace->add(launch); };
    }
    if (trace || preview.active())
        watch.on_step = [&preview, &trace](const WaveStep &step) {
            if (trace) trace->add(step);
            if (preview.active()) preview.add_step(step);
        };
    return watch;
}

int status_of(const RenderEnd &end) {
    if (!end.failure.empty()) throw Error(end.failure + "; the picture so far has been written: " + samples_taken(end));
    if (!end.complete()) fmt::print(stderr, "interrupted: {}{}\n", samples_taken(end), end.spp == 0 ? "; pixels not reached are black" : "");
    return end.complete() ? 0 : interrupted_status;
}

int render(const RenderCommandOptions &options) {
    const double start = seconds_now();
    const std::vector<PreviewTarget> targets = preview_targets(options);
    const std::optional<double> hold = hold_seconds(options);
    double read_seconds = 0;
    ProgressLine progress(options.quiet);
    Scene scene = timed(read_seconds, [&] { return read_with_progress(options, progress); });
    leave_out_aovs(options, scene);
    check_files(options, scene);

    Preview preview(targets, scene, options.outputs.files.front(), options.batch);
    for (const std::string &url : preview.urls()) fmt::print(stderr, "preview: {}\n", url);
    const std::function<void(const std::string &)> say = [&](const std::string &what) { progress.say(what), preview.say(what); };
    std::optional<Trace> trace;
    if (!options.trace.empty()) trace.emplace(options.trace, "brandung render " + options.scene, start).add_phase("read", start, seconds_now());
    const double prepared = seconds_now();
    Job job(scene, options, watch_of(preview, trace, progress, say), options.stop);
    preview.begin(job);
    progress.clear();
    print_warnings(options, job);
    check_memory(job);
    if (options.explain) print_result(explain(features(job)));
    handle_interruptions();
    if (!options.quiet) print_plan(job, options.stop);
    say("first batch: what the kernel cache does not have is compiled");

    PhaseSeconds seconds = job.seconds;
    seconds.read = read_seconds;
    const double begun = seconds_now();
    const auto [end, exposure] = render_pictures(options, job, seconds, preview, trace ? &*trace : nullptr, progress);
    preview.finish(end, job);
    if (trace) {
        trace->add_phase("prepare", prepared, begun), trace->add_phase("render and write", begun, seconds_now());
        trace->finish();
    }
    seconds.total = seconds_now() - start;
    if (!options.stats.empty()) write_text(options.stats, statistics(job, seconds, end).dump(2) + "\n");
    print_losses(job);
    if (scene.film.automatic_exposure)
        fmt::print(stderr, "exposure: --exposure {}{}\n", exposure, options.turntable ? ", which the first picture has chosen" : "");
    preview.hold(end.complete() ? hold : std::nullopt, [&, complete = end.complete()] { return complete && is_interrupted(); });
    print_faults(preview, progress);
    return status_of(end);
}

}  // namespace

void add_render(CLI::App &app, int &status) {
    CLI::App *command = app.add_subcommand("render", "render a scene to one or more pictures");
    auto options = std::make_shared<RenderCommandOptions>();
    add_render_options(*command, *options);
    command->callback([options, &status] {
        lift_limit_of_samples(*options);
        status = render(*options);
    });
}

}  // namespace brandung
