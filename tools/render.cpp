/// brandung render: from a scene file to pictures.
#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <set>

#include "brandung_version.h"
#include "scene/filters/filter.h"
#include "scene/image.h"
#include "scene/output.h"
#include "scene/scene_hash.h"
#include "tools/commands.h"
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
    std::string stats;
    std::vector<std::string> outputs;
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
    for (const std::string &output : options.outputs) check("--output", output);
    if (!options.stats.empty()) check("--stats", options.stats);
}

void check_outputs(const Options &options, const FilmSettings &film) {
    for (const std::string &output : options.outputs) check_picture_writable(output, film.width, film.height);
    if (!options.stats.empty()) check_writable(options.stats);
}

double mebibytes(std::size_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

void check_memory(const Job &job) {
    const DeviceInfo &device = job.device.info();
    if (job.bytes() > device.memory)
        throw Error(
            fmt::format("{}: rendering takes up to {:.1f} MiB (scene {:.1f}, textures {:.1f}, film {:.1f}, waves {:.1f}), but '{}' has {:.1f} MiB",
                        job.scene.file, mebibytes(job.bytes()), mebibytes(job.on_device.bytes()), mebibytes(job.on_device.texture_bytes()),
                        mebibytes(job.film.bytes()), mebibytes(job.renderer.wave_bytes()), device.name, mebibytes(device.memory)));
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
    const std::size_t texture_bytes = job.on_device.texture_bytes();
    const std::string textures = texture_bytes == 0 ? "" : fmt::format("textures {:.1f} MiB, ", mebibytes(texture_bytes));
    fmt::print(stderr, "{}: {} x {}, {} spp on {}; memory: scene {:.1f} MiB, {}film {:.1f} MiB, waves at most {:.1f} MiB\n", job.scene.file,
               film.width, film.height, film.spp, job.device.info().name, mebibytes(job.on_device.bytes()), textures, mebibytes(job.film.bytes()),
               mebibytes(job.renderer.wave_bytes()));
}

void print_notes(const Scene &scene) {
    for (const std::string &note : scene.notes) fmt::print(stderr, "{}\n", note);
}

std::string samples_taken(const RenderEnd &end) { return fmt::format("{} of {} samples", end.samples_done, end.samples_total); }

std::map<std::string, std::string> metadata(const Job &job, const PhaseSeconds &seconds, const RenderEnd &end) {
    const char *const positions[] = {"corner", "center", "random"};
    std::map<std::string, std::string> metadata = {{"Software", "brandung " BRANDUNG_VERSION " (" BRANDUNG_GIT ")"},
                                                   {"brandung:scene", job.scene.file},
                                                   {"brandung:scene_hash", fmt::format("{:016x}", scene_hash(job.scene, job.compiled))},
                                                   {"brandung:camera", job.camera.name},
                                                   {"brandung:integrator", job.scene.integrator.type},
                                                   {"brandung:max_depth", std::to_string(job.scene.integrator.max_depth)},
                                                   {"brandung:threshold", fmt::format("{}", job.scene.integrator.threshold)},
                                                   {"brandung:spp", std::to_string(job.scene.film.spp)},
                                                   {"brandung:seed", std::to_string(job.scene.film.seed)},
                                                   {"brandung:filter", filter_kinds()[job.scene.film.filter].name},
                                                   {"brandung:filter_radius", fmt::format("{}", job.scene.film.filter_radius)},
                                                   {"brandung:pixel", positions[job.scene.film.pixel]},
                                                   {"brandung:statistics", statistics(job, seconds, end).dump()}};
    if (!end.complete) metadata.insert({{"brandung:interrupted", "true"}, {"brandung:samples", samples_taken(end)}});
    return metadata;
}

void write_pictures(const Options &options, Job &job, const PhaseSeconds &seconds, const RenderEnd &end) {
    Picture picture{job.scene.film.width, job.scene.film.height, job.film.develop(), {}};
    if (std::any_of(options.outputs.begin(), options.outputs.end(), stores_metadata)) picture.metadata = metadata(job, seconds, end);
    for (const std::string &output : options.outputs) write_picture(output, picture, job.scene.film.exposure);
}

void print_losses(const Job &job) {
    if (const auto refused = job.renderer.integrator().refused())
        fmt::print(stderr, "warning: {} contributions were not finite and were left out\n", refused);
    if (const auto lost = job.renderer.integrator().media_lost())
        fmt::print(stderr, "warning: {} times a ray entered a transparent body from within {} others, and it was left out\n", lost,
                   max_interior_size);
    if (const auto clamped = job.film.clamped()) fmt::print(stderr, "warning: {} samples were brighter than 65536 and were cut\n", clamped);
}

int render(const Options &options) {
    const double start = seconds_now();
    check_distinct(options);
    double read_seconds = 0;
    ProgressLine progress(options.quiet);
    const auto on_read = [&](const std::string &file, double part) { progress.show_reading(file, part); };
    const Scene scene = timed(read_seconds, [&] { return read_scene(options, on_read); });
    progress.clear();
    check_outputs(options, scene.film);

    const auto on_progress = [&](const RenderProgress &done) {
        progress.show(done);
        return !interrupted;
    };
    Job job(scene, options, on_progress, [&](const std::string &file) { progress.say("building " + file); });
    progress.clear();
    print_warnings(job.compiled.warnings);
    check_memory(job);
    print_threads_beyond(options, job.device.info());
    if (options.explain) print_result(explain(features(job)));
    handle_interruptions();
    if (!options.quiet) print_notes(scene);
    if (!options.quiet) print_plan(job);
    progress.say("first batch: what the kernel cache does not have is compiled");

    PhaseSeconds seconds = job.seconds;
    seconds.read = read_seconds;
    const RenderEnd end = timed(seconds.render, [&] { return job.renderer.render(job.film); });
    progress.clear();

    double write_seconds = 0;
    timed(write_seconds, [&] { write_pictures(options, job, seconds, end); });
    seconds.write = write_seconds;
    seconds.total = seconds_now() - start;
    if (!options.stats.empty()) write_text(options.stats, statistics(job, seconds, end).dump(2) + "\n");
    print_losses(job);
    if (!end.failure.empty()) throw Error(end.failure + "; the picture so far has been written: " + samples_taken(end));
    if (!end.complete) fmt::print(stderr, "interrupted: {}; pixels not reached are black\n", samples_taken(end));
    return end.complete ? 0 : interrupted_status;
}

}  // namespace

void add_render(CLI::App &app, int &status) {
    CLI::App *command = app.add_subcommand("render", "render a scene to one or more pictures");
    auto options = std::make_shared<Options>();
    add_scene_options(*command, *options);
    command->add_option("-o,--output", options->outputs, "picture to write, its format by extension; several allowed")
        ->required()
        ->expected(1)
        ->take_all();
    command->add_option("--stats", options->stats, "write everything counted and timed to this JSON file");
    command->add_flag("--explain", options->explain, "print what the scene needs and what was skipped");
    command->add_flag("--quiet", options->quiet, "no progress");
    command->callback([options, &status] { status = render(*options); });
}

}  // namespace brandung
