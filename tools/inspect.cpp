/// brandung inspect: one pixel's tree of rays, with every hit, weight and contribution.
#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <charconv>

#include "scene/formats/limits.h"
#include "tools/commands.h"
#include "tools/inspection_json.h"
#include "tools/inspection_text.h"
#include "tools/job.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

struct Options : SceneOptions {
    std::string place, sample = "0";
    bool as_json = false, brief = false;
};

/// Reads the whole of `text` as a number; false if it is none.
bool read_number(std::string_view text, uint &number) {
    const auto [end, error] = std::from_chars(text.begin(), text.end(), number);
    return error == std::errc() && end == text.end();
}

struct Place {
    uint x, y;
};

/// Throws CLI::ValidationError if `text` is not the place of a pixel.
Place read_place(const std::string &text, const FilmSettings &film) {
    Place place{};
    const std::size_t comma = std::min(text.find(','), text.size() - 1);
    if (!read_number(text.substr(0, comma), place.x) || !read_number(text.substr(comma + 1), place.y))
        throw CLI::ValidationError("PIXEL", fmt::format("expected X,Y from the top left, got '{}'", text));
    const Window window = film.window();
    if (place.x < window.left || place.x >= window.right || place.y < window.top || place.y >= window.bottom)
        throw CLI::ValidationError("PIXEL", fmt::format("{} is outside the picture, whose pixels are {},{} to {},{}", text, window.left, window.top,
                                                        window.right - 1, window.bottom - 1));
    return place;
}

/// Throws CLI::ValidationError if `text` is neither "all" nor the number of a sample.
SampleRange read_samples(const std::string &text, uint spp) {
    if (text == "all") return {0, spp};
    uint number = 0;
    if (!read_number(text, number)) throw CLI::ValidationError("--sample", fmt::format("expected a number or 'all', got '{}'", text));
    if (number >= spp) throw CLI::ValidationError("--sample", fmt::format("{} is beyond the last sample, {}: film.spp is {}", number, spp - 1, spp));
    return {number, 1};
}

nlohmann::json inspect(const Options &options) {
    const Scene scene = read_scene(options);
    const Place place = read_place(options.place, scene.film);
    const SampleRange samples = read_samples(options.sample, scene.film.spp);
    Job job(scene, options);
    Film of_own_samples(job.device, scene.film.window());
    const InspectedPixel pixel =
        inspect_pixel({job.device, job.on_device, job.renderer, of_own_samples, scene.film.spp, options.batch}, place.x, place.y, samples);
    return inspection_json(scene, job.compiled, pixel, place.x, place.y);
}

}  // namespace

void add_inspect(CLI::App &app, int &) {
    CLI::App *command = app.add_subcommand("inspect", "show one pixel's tree of rays: hits, weights, contributions, in decimal and hexadecimal");
    auto options = std::make_shared<Options>();
    options->keep_places = true;
    add_scene_options(*command, *options);
    add_device_options(*command, *options);
    command->add_option("PIXEL", options->place, "X,Y: the pixel, from 0,0 at the top left")->required();
    command->add_option("--sample,--samples", options->sample, "number of the sample to show, from 0 on, or 'all'")->capture_default_str();
    command->add_flag("--brief", options->brief, "print the tree only, a line per ray");
    command->add_flag("--json", options->as_json, "print JSON");
    command->callback([options] {
        const nlohmann::json inspection = inspect(*options);
        print_result(options->as_json ? inspection.dump(2) + "\n" : inspection_text(inspection, options->brief));
    });
}

}  // namespace brandung
