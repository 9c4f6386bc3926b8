/// brandung render: from a scene file to pictures.
#include <fmt/core.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <memory>

#include "brandung_version.h"
#include "runtime/renderer.h"
#include "scene/error.h"
#include "scene/formats/format.h"
#include "scene/image.h"
#include "scene/output.h"
#include "tools/commands.h"
#include "tools/progress.h"
#include "tools/report.h"

namespace brandung {
namespace {

constexpr int interrupted_status = 130;
std::atomic<bool> interrupted = false;  // set by the signal handler, which may do no more

struct Options {
    std::string scene, stats, device, camera, integrator, accelerator, size, pixel;
    std::vector<std::string> outputs, assignments;
    uint spp = 0, seed = 0, max_depth = 0, batch = 32768, threads = 0;
    bool has_seed = false, explain = false, quiet = false;
};

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Runs a phase and gives the seconds it took.
template <class Phase> double timed(Phase phase) {
    const double start = now();
    phase();
    return now() - start;
}

/// The options that stand for settings of the scene file.
std::vector<std::string> assignments(const Options &options) {
    std::vector<std::string> all = options.assignments;
    const auto add = [&](const char *key, const std::string &value) { all.push_back(std::string(key) + "=" + value); };
    if (!options.size.empty()) {
        const auto cross = options.size.find('x');
        if (cross == std::string::npos) throw CLI::ValidationError("--size", "expected WIDTHxHEIGHT, got '" + options.size + "'");
        add("film.width", options.size.substr(0, cross)), add("film.height", options.size.substr(cross + 1));
    }
    if (options.spp) add("film.spp", std::to_string(options.spp));
    if (options.has_seed) add("film.seed", std::to_string(options.seed));
    if (!options.pixel.empty()) add("film.pixel", options.pixel);
    if (options.max_depth) add("integrator.max_depth", std::to_string(options.max_depth));
    if (!options.integrator.empty()) add("integrator.type", options.integrator);
    if (!options.accelerator.empty()) add("accelerator", options.accelerator);
    return all;
}

const CameraDescription &chosen_camera(const Scene &scene, const std::string &name) {
    for (const CameraDescription &camera : scene.cameras)
        if (name.empty() || camera.name == name) return camera;
    throw SceneError(scene.file + ": there is no camera '" + name + "'");
}

void print_warnings(const Scene &scene) {
    for (const auto &[text, count] : scene.warnings) fmt::print(stderr, "warning: {}{}\n", text, count > 1 ? fmt::format(" ({} times)", count) : "");
}

double mebibytes(std::size_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

std::map<std::string, std::string> metadata(const Scene &scene, const CompiledScene &compiled, const nlohmann::json &statistics) {
    return {{"Software", "brandung " BRANDUNG_VERSION " (" BRANDUNG_GIT ")"},
            {"brandung:scene", scene.file},
            {"brandung:scene_hash", fmt::format("{:016x}", scene_hash(scene, compiled))},
            {"brandung:integrator", scene.integrator.type},
            {"brandung:max_depth", std::to_string(scene.integrator.max_depth)},
            {"brandung:threshold", fmt::format("{}", scene.integrator.threshold)},
            {"brandung:spp", std::to_string(scene.film.spp)},
            {"brandung:seed", std::to_string(scene.film.seed)},
            {"brandung:statistics", statistics.dump()}};
}

/// What a render prepares once everything is read.
struct Job {
    Job(const Scene &scene, const Options &options, ProgressLine &progress)
        : compiled(compile(scene)), device(Device::select(options.device, options.threads)), on_device(device, compiled) {
        device.on_build([&progress](const std::string &file) { progress.say("building " + file); });
    }
    CompiledScene compiled;
    Device device;
    DeviceScene on_device;
};

int render(const Options &options) {
    const double start = now();
    ProgressLine progress(options.quiet);
    for (const std::string &output : options.outputs) check_picture_writable(output);
    if (!options.stats.empty()) check_writable(options.stats);
    PhaseSeconds seconds;
    Scene scene;
    seconds.read = timed([&] { scene = read_scene(options.scene, assignments(options)); });
    print_warnings(scene);

    std::unique_ptr<Job> job;
    seconds.scene = timed([&] { job = std::make_unique<Job>(scene, options, progress); });
    seconds.accelerator = job->compiled.accelerator_seconds;
    seconds.scene -= seconds.accelerator;
    std::unique_ptr<Film> film;
    std::unique_ptr<Renderer> renderer;
    seconds.kernels = timed([&] {
        RenderOptions render_options{.batch = options.batch, .on_progress = [&](const RenderProgress &done) {
                                         progress.show(done);
                                         return !interrupted;
                                     }};
        film = std::make_unique<Film>(job->device, scene.film.width, scene.film.height);
        renderer =
            std::make_unique<Renderer>(job->device, scene, job->compiled, job->on_device, chosen_camera(scene, options.camera), render_options);
    });
    progress.clear();
    if (!options.quiet)
        fmt::print(stderr, "{}: {} x {}, {} spp on {}; memory: scene {:.1f} MiB, film {:.1f} MiB, waves at most {:.1f} MiB\n", options.scene,
                   scene.film.width, scene.film.height, scene.film.spp, job->device.info().name, mebibytes(job->on_device.bytes()),
                   mebibytes(film->bytes()), mebibytes(renderer->wave_bytes()));
    if (options.explain) fmt::print("{}", explain(scene, job->compiled, renderer->integrator()));

    std::signal(SIGINT, [](int) { interrupted = true; });
    std::signal(SIGTERM, [](int) { interrupted = true; });
    bool complete = false;
    seconds.render = timed([&] { complete = renderer->render(*film); });
    progress.clear();

    RenderReport report{scene,         job->compiled,  job->device, renderer->integrator(), seconds, job->on_device.bytes(), renderer->wave_bytes(),
                        film->bytes(), film->clamped()};
    Picture picture{scene.film.width, scene.film.height, film->develop(), metadata(scene, job->compiled, statistics(report))};
    report.seconds.write = timed([&] {
        for (const std::string &output : options.outputs) write_picture(output, picture, scene.film.exposure);
    });
    report.seconds.total = now() - start;
    if (!options.stats.empty()) write_text(options.stats, statistics(report).dump(2) + "\n");
    if (const auto refused = renderer->integrator().refused())
        fmt::print(stderr, "warning: {} contributions were not finite and were left out\n", refused);
    if (report.clamped) fmt::print(stderr, "warning: {} samples were brighter than 65536 and were cut\n", report.clamped);
    if (!complete) fmt::print(stderr, "interrupted: the picture so far has been written\n");
    return complete ? 0 : interrupted_status;
}

}  // namespace

void add_render(CLI::App &app, int &status) {
    CLI::App *command = app.add_subcommand("render", "render a scene to one or more pictures");
    auto options = std::make_shared<Options>();
    command->add_option("scene", options->scene, "scene file: .json (native) or .nff")->required();
    command->add_option("-o,--output", options->outputs, "picture to write, its format by extension; several allowed")
        ->required()
        ->expected(1)
        ->take_all();
    command->add_option("--integrator", options->integrator, "how light gets to the eye (default: the scene's)");
    command->add_option("--accelerator", options->accelerator, "wide_bvh, none or auto (default: the scene's)");
    command->add_option("--spp", options->spp, "samples per pixel")->check(CLI::PositiveNumber);
    command->add_option("--size", options->size, "picture size as WIDTHxHEIGHT");
    command->add_option("--seed", options->seed, "seed of random numbers")->each([options](const std::string &) { options->has_seed = true; });
    command->add_option("--pixel", options->pixel, "where a single sample lies: corner, center or random");
    command->add_option("--camera", options->camera, "name of the scene's camera to use (default: the first)");
    command->add_option("--max-depth", options->max_depth, "rays in a chain, the eye ray being 1")->check(CLI::PositiveNumber);
    command->add_option("--set", options->assignments, "any setting of the scene file, as KEY=VALUE, such as integrator.threshold=0.01")
        ->expected(1)
        ->take_all();
    command->add_option("--device", options->device, "OpenCL device whose name contains this");
    command->add_option("--batch", options->batch, "rays per wave")->check(CLI::Range(1u, 1u << 24))->capture_default_str();
    command->add_option("--threads", options->threads, "compute units to use of a CPU (default: all)");
    command->add_option("--stats", options->stats, "write everything counted and timed to this JSON file");
    command->add_flag("--explain", options->explain, "print what the scene needs and what was skipped");
    command->add_flag("--quiet", options->quiet, "no progress");
    command->callback([options, &status] { status = render(*options); });
}

}  // namespace brandung
