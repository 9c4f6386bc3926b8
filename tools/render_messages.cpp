#include "tools/render_messages.h"

#include <fmt/core.h>

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
    fmt::print(stderr, "{}", warnings_text(job.compiled.warnings, job.scene.warning_places));
    const DeviceInfo &device = job.device.info();
    if (options.threads > device.compute_units)
        fmt::print(stderr, "warning: --threads {}: '{}' has only {} compute units\n", options.threads, device.name, device.compute_units);
}

void print_plan(const Job &job) {
    for (const std::string &note : job.scene.notes) fmt::print(stderr, "{}\n", note);
    const FilmSettings &film = job.scene.film;
    const Window window = film.window();
    const std::size_t texture_bytes = job.on_device.texture_bytes();
    const std::string textures = texture_bytes == 0 ? "" : fmt::format("textures {:.1f} MiB, ", mebibytes(texture_bytes));
    const std::string part = film.crop ? fmt::format(" (from {}, {} on, of {} x {})", window.left, window.top, film.width, film.height) : "";
    fmt::print(stderr, "{}: {} x {}{}, {} spp on {}; memory: scene {:.1f} MiB, {}film {:.1f} MiB, waves at most {:.1f} MiB\n", job.scene.file,
               window.width(), window.height(), part, film.spp, job.device.info().name, mebibytes(job.on_device.bytes()), textures,
               mebibytes(job.film_bytes()), mebibytes(job.renderer.wave_bytes()));
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
