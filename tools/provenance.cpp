#include "tools/provenance.h"

#include <fmt/format.h>

#include "brandung_version.h"
#include "scene/filters/filter.h"
#include "scene/samplers/sampler.h"
#include "scene/scene_hash.h"

namespace brandung {

std::string program_version() { return "brandung " BRANDUNG_VERSION " (" BRANDUNG_GIT ")"; }

std::string text_of(const Bundles &bundles) {
    return fmt::format("light={},diffuse={},glossy={},transmission={}", bundles.light, bundles.diffuse, bundles.glossy, bundles.transmission);
}

std::string scene_fingerprint(const Job &job) { return fmt::format("{:016x}", scene_hash(job.scene, job.compiled)); }

std::map<std::string, std::string> settings_of(const Job &job) {
    const char *const positions[] = {"corner", "center", "random"};
    const FilmSettings &film = job.scene.film;
    const Window window = film.window();
    const IntegratorSettings &integrator = job.scene.integrator;
    return {{"width", std::to_string(film.width)},
            {"height", std::to_string(film.height)},
            {"crop", fmt::format("{},{},{},{}", window.left, window.top, window.right, window.bottom)},
            {"camera", job.camera.name},
            {"integrator", integrator.type},
            {"max_depth", std::to_string(integrator.max_depth)},
            {"threshold", fmt::format("{}", integrator.threshold)},
            {"light_samples", std::to_string(integrator.light_samples)},
            {"bundles", text_of(integrator.bundles_in_use())},
            {"follow", integrator.follows_one ? "one" : "both"},
            {"shadows", integrator.filtered_shadows ? "filtered" : "opaque"},
            {"seed", std::to_string(film.seed)},
            {"sampler", sampler_kinds()[film.sampler].name},
            {"filter", filter_kinds()[film.filter].name},
            {"filter_radius", fmt::format("{}", film.filter_radius)},
            {"splat", splats(film) ? "yes" : "no"},
            {"pixel", positions[film.pixel]}};
}

}  // namespace brandung
