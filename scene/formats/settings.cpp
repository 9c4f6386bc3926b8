/// Settings that every scene format takes: film, integrator, accelerator.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/accelerators/accelerator.h"
#include "scene/aovs/aov.h"
#include "scene/filters/filter.h"
#include "scene/formats/format.h"
#include "scene/formats/limits.h"
#include "scene/parameters.h"
#include "scene/samplers/sampler.h"
#include "scene/textures/textured.h"
#include "scene/tone.h"
#include "scene/warnings.h"

namespace brandung {
namespace {

constexpr uint max_resolution = 65535;
constexpr float max_filter_radius = 100;  ///< [pixels]
constexpr float max_exposure = 100;       ///< [EV]: the brightest radiance of a film, 2^16, times 2 to this power is a float

void read_filter(const Parameters &parameters, FilmSettings &film) {
    std::vector<std::string> names;
    for (const FilterKind &kind : filter_kinds()) names.emplace_back(kind.name);
    film.filter = parameters.choice("filter", names, film.filter);
    const FilterKind &kind = filter_kinds()[film.filter];
    film.filter_radius = parameters.positive("filter_radius", kind.radius);
    if (parameters.has("filter_radius") && !kind.has_radius)
        parameters.fail("filter_radius", fmt::format("the {} is the pixel itself and takes no radius", kind.name));
    if (film.filter_radius > max_filter_radius)
        parameters.fail("filter_radius", fmt::format("must be at most {:g} pixels, got {:g}", max_filter_radius, film.filter_radius));
    if (film.pixel == PIXEL_CORNER && kind.has_radius) parameters.fail("filter", "pixels at corners take no filter but the box");
    film.splat = parameters.boolean("splat", film.splat);
    if (film.splat && filter_params(kind, film.filter_radius).negative_tail > 0)
        parameters.fail(
            "splat", fmt::format("needs a filter that is nowhere negative, since the weights of few samples of {} may sum up to nothing", kind.name));
    if (splats(film) && (film.filter_radius < min_splat_radius || film.filter_radius > max_splat_radius))
        parameters.fail("filter_radius", fmt::format("must be from {:g} to {:g} pixels where samples are splatted, got {:g}", min_splat_radius,
                                                     max_splat_radius, film.filter_radius));
}

void read_crop(const Parameters &parameters, FilmSettings &film) {
    if (!parameters.has("crop")) return;
    const std::vector<uint> edges = parameters.integers("crop");
    if (edges.size() != 4) parameters.fail("crop", fmt::format("must be an array of 4 numbers, got one of {}", edges.size()));
    film.crop = Window{edges[0], edges[1], edges[2], edges[3]};
    if (film.crop->left >= film.crop->right || film.crop->top >= film.crop->bottom)
        parameters.fail("crop", "has no pixels: must be X0, Y0, X1, Y1 with X0 < X1 and Y0 < Y1");
    if (film.crop->right > film.width || film.crop->bottom > film.height)
        parameters.fail("crop", fmt::format("reaches beyond the picture of {} x {} pixels", film.width, film.height));
}

/// Of pictures of integers.
void read_development(const Parameters &parameters, FilmSettings &film) {
    std::vector<std::string> tones;
    for (const ToneKind &kind : tone_kinds()) tones.emplace_back(kind.name);
    film.tone = parameters.choice("tone", tones, film.tone);
    film.automatic_exposure = parameters.is_text("exposure");
    if (!film.automatic_exposure) film.exposure = parameters.number("exposure", film.exposure);
    if (film.automatic_exposure && parameters.text("exposure") != "auto")
        parameters.fail("exposure", fmt::format("must be a number or \"auto\", got \"{}\"", parameters.text("exposure")));
    if (std::abs(film.exposure) > max_exposure)
        parameters.fail("exposure", fmt::format("must be from -{0:g} to {0:g} EV, got {1:g}", max_exposure, film.exposure));
}

void read_aovs(const Parameters &parameters, FilmSettings &film) {
    const std::vector<std::string> names = parameters.texts("aovs");
    std::vector<std::string> known = {"all"};
    for (const AovKind &kind : aov_kinds()) known.emplace_back(kind.name);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (std::find(known.begin(), known.end(), names[i]) == known.end())
            parameters.fail_element("aovs", i, fmt::format("must be one of {}, got \"{}\"", fmt::join(known, ", "), names[i]));
    for (uint kind = 0; kind < aov_kinds().size(); ++kind)
        if (std::any_of(names.begin(), names.end(), [&](const std::string &name) { return name == "all" || name == aov_kinds()[kind].name; }))
            film.aovs.push_back(kind);
}

void read_film(const Parameters &parameters, FilmSettings &film) {
    film.width = parameters.integer("width", film.width, 1, max_resolution);
    film.height = parameters.integer("height", film.height, 1, max_resolution);
    film.pixel = parameters.choice("pixel", {"corner", "center", "random"}, film.pixel);
    film.spp = parameters.integer("spp", film.pixel == PIXEL_CORNER ? 1 : film.spp, 1, max_samples);
    film.seed = parameters.integer("seed", film.seed);
    std::vector<std::string> samplers;
    for (const SamplerKind &kind : sampler_kinds()) samplers.emplace_back(kind.name);
    film.sampler = parameters.choice("sampler", samplers, film.sampler);
    read_filter(parameters, film);
    if (film.pixel == PIXEL_CORNER && film.spp != 1) parameters.fail("pixel", fmt::format("'corner' takes one sample per pixel, not {}", film.spp));
    read_aovs(parameters, film);
    read_crop(parameters, film);
    read_development(parameters, film);
    parameters.expect_all_known();
}

static_assert(max_depth + 1 < 1u << SURFACE_BITS && MAX_BUNDLE == 1u << PART_BITS);

Bundles read_bundles(const Parameters &parameters, Bundles bundles) {
    const auto size = [&](const char *kind, uint fallback) { return parameters.integer(kind, fallback, 1, MAX_BUNDLE); };
    bundles = {size("light", bundles.light), size("diffuse", bundles.diffuse), size("glossy", bundles.glossy),
               size("transmission", bundles.transmission)};
    parameters.expect_all_known();
    return bundles;
}

void warn_of_unused_splats(const Parameters &film, Scene &scene) {
    if (!scene.film.splat || splats(scene.film)) return;
    ++scene.warnings[fmt::format("film.splat has no effect with the filter {}", filter_kinds()[scene.film.filter].name)];
    place_warnings(scene, [&] { return film.place("splat"); });
}

/// Of what is set to no avail.
void warn_of_unused(const Parameters &parameters, Scene &scene) {
    const IntegratorSettings &integrator = scene.integrator;
    const bool paths = integrator.traces_paths();
    const auto expect_used = [&](const char *key, bool is_used) {
        if (is_used || !parameters.has(key)) return;
        ++scene.warnings[fmt::format("integrator.{} has no effect with {}", key, integrator.type)];
        place_warnings(scene, [&] { return parameters.place(key); });
    };
    expect_used("light_samples", !paths || integrator.light_samples <= 1);
    expect_used("threshold", !paths || integrator.threshold == 0);
    expect_used("follow", !paths || !integrator.follows_one);
    expect_used("shadows", !paths || !integrator.filtered_shadows);
    expect_used("bundles", integrator.type == "distributed");
    expect_used("roulette_depth", paths);
}

void read_integrator(const Parameters &parameters, Scene &scene) {
    IntegratorSettings &integrator = scene.integrator;
    integrator.type = parameters.text("type", integrator.type);
    // Finding the line takes as long as reading the file again; the default is never refused.
    if (integrator.type != IntegratorSettings().type) integrator.type_place = parameters.place("type");
    integrator.max_depth = parameters.integer("max_depth", integrator.max_depth, 1, max_depth);
    integrator.threshold = parameters.not_negative("threshold", integrator.threshold);
    integrator.light_samples = parameters.integer("light_samples", integrator.light_samples, 0, MAX_LIGHT_SAMPLES);
    integrator.bundles = read_bundles(parameters.child("bundles"), integrator.bundles);
    integrator.roulette_depth = parameters.integer("roulette_depth", integrator.roulette_depth, 1, max_depth);
    integrator.follows_one = parameters.choice("follow", {"both", "one"}, integrator.follows_one ? 1 : 0) == 1;
    if (parameters.has("shadows")) integrator.shadows_unsaid = false;
    integrator.filtered_shadows = parameters.choice("shadows", {"opaque", "filtered"}, integrator.filtered_shadows ? 1 : 0) == 1;
    parameters.expect_all_known();
    warn_of_unused(parameters, scene);
}

}  // namespace

void read_settings(const Parameters &root, Scene &scene) {
    // PIXEL_... number the choices of film.pixel.
    static_assert(PIXEL_CORNER == 0 && PIXEL_CENTER == 1 && PIXEL_RANDOM == 2);
    read_film(root.child("film"), scene.film);
    warn_of_unused_splats(root.child("film"), scene);
    read_integrator(root.child("integrator"), scene);
    std::vector<std::string> accelerators = {"auto"};
    for (const AcceleratorKind &kind : accelerator_kinds()) accelerators.emplace_back(kind.name);
    read_background(root, scene);
    place_warnings(scene, [&] { return root.place("background"); });
    if (root.has("accelerator")) scene.accelerator = accelerators[root.choice("accelerator", accelerators)];
    const std::vector<std::string> qualities(build_quality_names.begin(), build_quality_names.end());
    scene.accelerator_quality = BuildQuality(root.choice("accelerator_quality", qualities, uint(scene.accelerator_quality)));
}

void assign_settings(const std::vector<std::string> &assignments, Scene &scene) {
    Document settings{.file = scene.file, .text = "", .root = nlohmann::json::object(), .assigned = {}, .progress = {}};
    for (const std::string &assignment : assignments) set_value(settings, assignment);
    const Parameters root(settings, "");
    read_settings(root, scene);
    root.expect_all_known();
}

}  // namespace brandung
