#include "tools/render_messages.h"

#include <fmt/core.h>

#include <utility>

#include "scene/filters/filter.h"
#include "scene/formats/limits.h"
#include "tools/report.h"
#include "tools/report_text.h"

namespace brandung {

void check_memory(const Job &job) {
    const DeviceInfo &device = job.device.info();
    if (job.bytes() > device.memory)
        throw Error(
            fmt::format("{}: rendering takes up to {:.1f} MiB (scene {:.1f}, textures {:.1f}, film {:.1f}, waves {:.1f}), but '{}' has {:.1f} MiB",
                        job.scene.file, mebibytes(job.bytes()), mebibytes(job.on_device.bytes()), mebibytes(job.on_device.texture_bytes()),
                        mebibytes(job.film_bytes()), mebibytes(job.renderer.wave_bytes()), device.name, mebibytes(device.memory)));
}

void print_warnings(const RenderCommandOptions &options, const Job &job) {
    fmt::print(stderr, "{}", warnings_text(job.compiled.warnings, job.compiled.warning_places));
    const DeviceInfo &device = job.device.info();
    if (options.threads > device.compute_units)
        fmt::print(stderr, "warning: --threads {}: '{}' has only {} compute units\n", options.threads, device.name, device.compute_units);
}

namespace {

/// "16 spp", "until the noise is below 0.01 or 60 s have passed".
std::string extent_text(const FilmSettings &film, const StopRules &stop) {
    std::string text = film.spp == max_samples ? "" : fmt::format("{} spp", film.spp);
    const auto add = [&](const std::string &rule) { text += (text.empty() ? "until " : " or ") + rule; };
    if (stop.error) add(fmt::format("the noise is below {:g}", *stop.error));
    if (stop.seconds) add(fmt::format("{:g} s have passed", *stop.seconds));
    return text.empty() ? fmt::format("{} spp", film.spp) : text;
}

}  // namespace

void print_plan(const Job &job, const StopRules &stop) {
    for (const std::string &note : job.scene.notes) fmt::print(stderr, "{}\n", note);
    const FilmSettings &film = job.scene.film;
    const Window window = film.window();
    const std::size_t texture_bytes = job.on_device.texture_bytes();
    const std::string textures = texture_bytes == 0 ? "" : fmt::format("textures {:.1f} MiB, ", mebibytes(texture_bytes));
    const std::string part = film.crop ? fmt::format(" (from {}, {} on, of {} x {})", window.left, window.top, film.width, film.height) : "";
    fmt::print(stderr, "{}: {} x {}{}, {} on {}; memory: scene {:.1f} MiB, {}film {:.1f} MiB, waves at most {:.1f} MiB\n", job.scene.file,
               window.width(), window.height(), part, extent_text(film, stop), job.device.info().name, mebibytes(job.on_device.bytes()), textures,
               mebibytes(job.film_bytes()), mebibytes(job.renderer.wave_bytes()));
}

void print_noise(const Job &job, const RenderEnd &end, const std::string &prefix) {
    if (!end.noise) return;
    const double spp = static_cast<double>(end.samples_done) / static_cast<double>(sampled_window(job.scene.film).pixels());
    std::string text = fmt::format("{}noise: relMSE {:.3g}, with a confidence of 95 % from {:.3g} to {:.3g}, after {:.4g} spp", prefix,
                                   end.noise->relmse, end.noise->low, end.noise->high, spp);
    std::string separator = "; wrong beyond that: ";
    for (const auto &bias : biases(job)) text += std::exchange(separator, ", ") + bias["why"].get<std::string>();
    fmt::print(stderr, "{}\n", text);
}

void print_missed_error(const RenderEnd &end, const StopRules &stop, const std::string &prefix) {
    if (!stop.error || !end.complete() || end.stopped_by == StoppedBy::error) return;
    const std::string limit = end.stopped_by == StoppedBy::time ? fmt::format("{:g} s", *stop.seconds) : fmt::format("{} spp", end.spp);
    if (end.noise)
        fmt::print(stderr, "warning: {}the noise is not below {:g}: {} came first\n", prefix, *stop.error, limit);
    else
        fmt::print(stderr, "warning: {}whether the noise is below {:g} is not known: {} came first, and it takes two samples of every pixel\n",
                   prefix, *stop.error, limit);
}

void print_losses(const Job &job) {
    if (const auto refused = job.renderer.integrator().refused())
        fmt::print(stderr, "warning: {} contributions were not finite and were left out\n", refused);
    if (const auto lost = job.renderer.integrator().media_lost())
        fmt::print(stderr, "warning: {} times a ray entered a transparent body from within {} others, and it was left out\n", lost,
                   max_interior_size);
    if (const auto clamped = job.film.clamped()) fmt::print(stderr, "warning: {} samples were brighter than 65536 and were cut\n", clamped);
}

void print_faults(Preview &preview, ProgressLine &progress) {
    for (const std::string &fault : preview.take_faults()) {
        progress.clear();
        fmt::print(stderr, "warning: {}\n", fault);
    }
}

}  // namespace brandung
