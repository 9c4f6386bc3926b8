/// brandung render: from a scene file to pictures.
#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <limits>
#include <numbers>
#include <set>

#include "scene/error.h"
#include "scene/output.h"
#include "scene/view.h"
#include "tools/commands.h"
#include "tools/outputs.h"
#include "tools/preview/preview.h"
#include "tools/progress.h"
#include "tools/report.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

constexpr int interrupted_status = 130;
std::atomic<bool> interrupted = false;  // set by the signal handler, which may do no more

/// The first signal ends the render with its batch, a second one the program.
void handle_interruptions() {
    struct sigaction action {};
    action.sa_handler = [](int) { interrupted = true; };
    action.sa_flags = SA_RESETHAND;
    for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

struct Options : SceneOptions {
    OutputOptions outputs;
    std::string stats;
    std::vector<std::string> previews;
    std::string preview_hold;
    std::optional<double> save_every;  ///< [s]
    std::optional<uint> turntable;     ///< pictures
    uint pictures() const { return turntable.value_or(1); }
    OutputOptions outputs_of(uint picture) const { return turntable ? numbered(outputs, picture) : outputs; }
    bool explain = false, quiet = false;
};

/// One name per file, however it is spelt; the spelling itself where the system does not tell.
std::filesystem::path canonical_name(const std::string &file) {
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::absolute(file, error);
    const std::filesystem::path canonical = error ? absolute : std::filesystem::weakly_canonical(absolute, error);
    return error ? std::filesystem::path(file) : canonical;
}

/// Of two files in one place the later would replace the earlier.
void check_distinct(const Options &options) {
    std::set<std::filesystem::path> known = {canonical_name(options.scene)};
    const auto check = [&](const char *option, const std::string &file) {
        if (!known.insert(canonical_name(file)).second) throw CLI::ValidationError(option, "'" + file + "' is the scene or another output already");
    };
    for (const std::string &output : options.outputs.files) check("--output", output);
    if (!options.stats.empty()) check("--stats", options.stats);
}

std::vector<PreviewTarget> preview_targets(const Options &options) {
    std::vector<PreviewTarget> targets;
    for (const std::string &preview : options.previews) targets.push_back(read_preview_target(preview));
    return targets;
}

/// Nothing where nothing is said.
std::optional<double> hold_seconds(const Options &options) {
    const std::string &text = options.preview_hold;
    if (text.empty()) return std::nullopt;
    if (std::none_of(options.previews.begin(), options.previews.end(), [](const std::string &preview) { return preview.starts_with("web"); }))
        throw CLI::ValidationError("--preview-hold", "there is no --preview web");
    double seconds = std::numeric_limits<double>::infinity();
    if (text != "forever" && !(CLI::detail::lexical_cast(text, seconds) && seconds >= 0))
        throw CLI::ValidationError("--preview-hold", "expected seconds or forever, got '" + text + "'");
    return seconds;
}

double mebibytes(std::size_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

void check_memory(const Job &job) {
    const DeviceInfo &device = job.device.info();
    if (job.bytes() > device.memory)
        throw Error(
            fmt::format("{}: rendering takes up to {:.1f} MiB (scene {:.1f}, textures {:.1f}, film {:.1f}, waves {:.1f}), but '{}' has {:.1f} MiB",
                        job.scene.file, mebibytes(job.bytes()), mebibytes(job.on_device.bytes()), mebibytes(job.on_device.texture_bytes()),
                        mebibytes(job.film_bytes()), mebibytes(job.renderer.wave_bytes()), device.name, mebibytes(device.memory)));
}

void print_warnings(const std::map<std::string, uint> &warnings) {
    for (const auto &[text, count] : warnings) fmt::print(stderr, "warning: {}{}\n", text, count > 1 ? fmt::format(" ({} times)", count) : "");
}

void print_threads_beyond(const Options &options, const DeviceInfo &device) {
    if (options.threads > device.compute_units)
        fmt::print(stderr, "warning: --threads {}: '{}' has only {} compute units\n", options.threads, device.name, device.compute_units);
}

void print_plan(const Job &job) {
    const FilmSettings &film = job.scene.film;
    const Window window = film.window();
    const std::size_t texture_bytes = job.on_device.texture_bytes();
    const std::string textures = texture_bytes == 0 ? "" : fmt::format("textures {:.1f} MiB, ", mebibytes(texture_bytes));
    const std::string part = film.crop ? fmt::format(" (from {}, {} on, of {} x {})", window.left, window.top, film.width, film.height) : "";
    fmt::print(stderr, "{}: {} x {}{}, {} spp on {}; memory: scene {:.1f} MiB, {}film {:.1f} MiB, waves at most {:.1f} MiB\n", job.scene.file,
               window.width(), window.height(), part, film.spp, job.device.info().name, mebibytes(job.on_device.bytes()), textures,
               mebibytes(job.film_bytes()), mebibytes(job.renderer.wave_bytes()));
}

void print_faults(Preview &preview, ProgressLine &progress) {
    for (const std::string &fault : preview.take_faults()) {
        progress.clear();
        fmt::print(stderr, "warning: {}\n", fault);
    }
}

void print_notes(const Scene &scene) {
    for (const std::string &note : scene.notes) fmt::print(stderr, "{}\n", note);
}

/// Writes the pictures so far now and then, but not the last, which are written anyway; where that fails the render goes on.
Observer saving(double every, const OutputOptions &outputs, Job &job, PhaseSeconds seconds, ProgressLine &progress) {
    return {every, [&, outputs, seconds](const RenderProgress &done) mutable {
                if (done.samples_done == done.samples_total) return true;
                seconds.render = done.seconds;
                try {
                    write_outputs(outputs, job, seconds, {false, "", done.samples_done, done.samples_total}, true);
                } catch (const SceneError &error) {
                    progress.clear();
                    fmt::print(stderr, "warning: {}\n", error.what());
                }
                return true;
            }};
}

void print_losses(const Job &job) {
    if (const auto refused = job.renderer.integrator().refused())
        fmt::print(stderr, "warning: {} contributions were not finite and were left out\n", refused);
    if (const auto lost = job.renderer.integrator().media_lost())
        fmt::print(stderr, "warning: {} times a ray entered a transparent body from within {} others, and it was left out\n", lost,
                   max_interior_size);
    if (const auto clamped = job.film.clamped()) fmt::print(stderr, "warning: {} samples were brighter than 65536 and were cut\n", clamped);
}

/// Progress of a picture as a part of them all.
class Sequence {
public:
    explicit Sequence(uint pictures) : pictures_(pictures) {}
    RenderProgress whole(const RenderProgress &of_picture) const {
        const std::uint64_t samples = of_picture.samples_total;
        return {done_ * samples + of_picture.samples_done, pictures_ * samples, seconds_now() - start_};
    }
    void begin_next() { ++done_; }

private:
    std::uint64_t pictures_, done_ = 0;
    double start_ = seconds_now();
};

/// Who is told of every picture alike.
std::vector<Observer> observers_of_all(const Sequence &sequence, Job &job, Preview &preview, ProgressLine &progress) {
    std::vector<Observer> observers = {{0, [&](const RenderProgress &of_picture) {
                                            progress.show(sequence.whole(of_picture));
                                            return !interrupted;
                                        }}};
    if (preview.active())
        observers.push_back({0, [&](const RenderProgress &of_picture) {
                                 preview.after_batch(sequence.whole(of_picture), job);
                                 print_faults(preview, progress);
                                 return true;
                             }});
    return observers;
}

/// Renders and writes the pictures one after another, each from a camera turned further. Gives the end of them all, and the exposure of the last.
std::pair<RenderEnd, float> render_pictures(const Options &options, Job &job, PhaseSeconds &seconds, Preview &preview, ProgressLine &progress) {
    Sequence sequence(options.pictures());
    const std::vector<Observer> of_all = observers_of_all(sequence, job, preview, progress);
    RenderEnd all{.complete = true, .failure = "", .samples_done = 0, .samples_total = 0};
    float exposure = 0;
    double write_seconds = 0;
    for (uint picture = 0; picture < options.pictures() && all.complete; ++picture) {
        const OutputOptions outputs = options.outputs_of(picture);
        if (picture > 0) {
            job.renderer.look_from(turned(job.camera, 2 * std::numbers::pi * picture / options.pictures()));
            job.film.clear();
            if (job.aovs) job.aovs->clear();
            sequence.begin_next();
        }
        std::vector<Observer> observers = of_all;
        if (options.save_every) observers.push_back(saving(*options.save_every, outputs, job, seconds, progress));
        const RenderEnd end = timed(seconds.render, [&] { return job.renderer.render(job.film, observers, job.aovs ? &*job.aovs : nullptr); });
        progress.clear();
        exposure = timed(write_seconds, [&] { return write_outputs(outputs, job, seconds, end, false); });
        all = {end.complete, end.failure, all.samples_done + end.samples_done, options.pictures() * end.samples_total};
    }
    seconds.write = write_seconds;
    return {all, exposure};
}

int render(const Options &options) {
    const double start = seconds_now();
    check_distinct(options);
    const std::vector<PreviewTarget> targets = preview_targets(options);
    const std::optional<double> hold = hold_seconds(options);
    double read_seconds = 0;
    ProgressLine progress(options.quiet);
    const auto on_read = [&](const std::string &file, double part) { progress.show_reading(file, part); };
    const Scene scene = timed(read_seconds, [&] { return read_scene(options, on_read); });
    progress.clear();
    for (uint picture = 0; picture < options.pictures(); ++picture) check_outputs(options.outputs_of(picture), scene.film);
    if (!options.stats.empty()) check_writable(options.stats);

    Preview preview(targets, scene, options.outputs.files.front(), options.batch);
    for (const std::string &url : preview.urls()) fmt::print(stderr, "preview: {}\n", url);

    const auto say = [&](const std::string &what) { progress.say(what), preview.say(what); };
    const WatchSteps on_step = preview.active() ? [&](const WaveStep &step) { preview.add_step(step); } : WatchSteps();
    Job job(
        scene, options, [&](const std::string &file) { say("building " + file); }, on_step);
    preview.begin(job);
    progress.clear();
    print_warnings(job.compiled.warnings);
    check_memory(job);
    print_threads_beyond(options, job.device.info());
    if (options.explain) print_result(explain(features(job)));
    handle_interruptions();
    if (!options.quiet) print_notes(scene);
    if (!options.quiet) print_plan(job);
    say("first batch: what the kernel cache does not have is compiled");

    PhaseSeconds seconds = job.seconds;
    seconds.read = read_seconds;
    const std::pair<RenderEnd, float> rendered = render_pictures(options, job, seconds, preview, progress);
    const RenderEnd &end = rendered.first;
    preview.finish(end, job);
    seconds.total = seconds_now() - start;
    if (!options.stats.empty()) write_text(options.stats, statistics(job, seconds, end).dump(2) + "\n");
    print_losses(job);
    if (scene.film.automatic_exposure) fmt::print(stderr, "exposure: --exposure {}\n", rendered.second);
    preview.hold(end.complete ? hold : std::nullopt, [&] { return end.complete && interrupted; });
    print_faults(preview, progress);
    if (!end.failure.empty()) throw Error(end.failure + "; the picture so far has been written: " + samples_taken(end));
    if (!end.complete) fmt::print(stderr, "interrupted: {}; pixels not reached are black\n", samples_taken(end));
    return end.complete ? 0 : interrupted_status;
}

}  // namespace

void add_render(CLI::App &app, int &status) {
    CLI::App *command = app.add_subcommand("render", "render a scene to one or more pictures");
    auto options = std::make_shared<Options>();
    add_scene_options(*command, *options);
    add_output_options(*command, options->outputs);
    command->add_option("--save-every", options->save_every, "while rendering write the pictures so far every so many seconds")
        ->check(CLI::PositiveNumber);
    command
        ->add_option("--turntable", options->turntable, "render so many pictures, the camera going once around what it looks at: NAME_000.png, ...")
        ->check(CLI::Range(1u, 1000u));
    command->add_option("--stats", options->stats, "write everything counted and timed to this JSON file");
    command
        ->add_option("--preview", options->previews,
                     "show the growing picture: tev[:HOST:PORT] in the viewer tev (default 127.0.0.1:14158), web[:PORT] on a page for browsers on "
                     "this machine (default 8080, 0 for any free port); several allowed")
        ->expected(1)
        ->take_all();
    command->add_option("--preview-hold", options->preview_hold,
                        "seconds that the page stays after the render, or forever, until Ctrl-C (default: 2 if it is open somewhere, else 0)");
    command->add_flag("--explain", options->explain, "print what the scene needs and what was skipped");
    command->add_flag("--quiet", options->quiet, "no progress");
    command->callback([options, &status] { status = render(*options); });
}

}  // namespace brandung
