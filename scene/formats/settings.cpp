/// Settings that every scene format takes: film, integrator, accelerator.
#include <fmt/format.h>

#include <cmath>

#include "scene/accelerators/accelerator.h"
#include "scene/filters/filter.h"
#include "scene/formats/format.h"
#include "scene/formats/limits.h"
#include "scene/parameters.h"
#include "scene/textures/textured.h"

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
}

void read_film(const Parameters &parameters, FilmSettings &film) {
    film.width = parameters.integer("width", film.width, 1, max_resolution);
    film.height = parameters.integer("height", film.height, 1, max_resolution);
    film.spp = parameters.integer("spp", film.spp, 1, max_samples);
    film.seed = parameters.integer("seed", film.seed);
    film.pixel = parameters.choice("pixel", {"corner", "center", "random"}, film.pixel);
    read_filter(parameters, film);
    if (film.pixel == PIXEL_CORNER && film.spp != 1) parameters.fail("pixel", fmt::format("'corner' takes one sample per pixel, not {}", film.spp));
    film.exposure = parameters.number("exposure", film.exposure);
    if (std::abs(film.exposure) > max_exposure)
        parameters.fail("exposure", fmt::format("must be from -{0:g} to {0:g} EV, got {1:g}", max_exposure, film.exposure));
    parameters.expect_all_known();
}

void read_integrator(const Parameters &parameters, IntegratorSettings &integrator) {
    integrator.type = parameters.text("type", integrator.type);
    // Finding the line takes as long as reading the file again; the default is never refused.
    if (integrator.type != IntegratorSettings().type) integrator.type_place = parameters.place("type");
    integrator.max_depth = parameters.integer("max_depth", integrator.max_depth, 1, max_depth);
    integrator.threshold = parameters.not_negative("threshold", integrator.threshold);
    parameters.expect_all_known();
}

}  // namespace

void read_settings(const Parameters &root, Scene &scene) {
    // PIXEL_... number the choices of film.pixel.
    static_assert(PIXEL_CORNER == 0 && PIXEL_CENTER == 1 && PIXEL_RANDOM == 2);
    read_film(root.child("film"), scene.film);
    read_integrator(root.child("integrator"), scene.integrator);
    std::vector<std::string> accelerators = {"auto"};
    for (const AcceleratorKind &kind : accelerator_kinds()) accelerators.emplace_back(kind.name);
    read_background(root, scene);
    if (root.has("accelerator")) scene.accelerator = accelerators[root.choice("accelerator", accelerators)];
}

void assign_settings(const std::vector<std::string> &assignments, Scene &scene) {
    Document settings{.file = scene.file, .text = "", .root = nlohmann::json::object(), .assigned = {}, .progress = {}};
    for (const std::string &assignment : assignments) set_value(settings, assignment);
    const Parameters root(settings, "");
    read_settings(root, scene);
    root.expect_all_known();
}

}  // namespace brandung
