/// brandung compare: how far a picture is from its reference.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "scene/error.h"
#include "scene/measures/heat_colour.h"
#include "scene/measures/measures.h"
#include "tools/commands.h"
#include "tools/distinct_files.h"
#include "tools/numbers.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

using nlohmann::json;

constexpr int beyond_tolerance = 3;  ///< exit status

struct Options {
    std::string test, reference, diff;
    std::vector<std::string> tolerances;  ///< "MEASURE=VALUE"
    double pixels_per_degree = default_pixels_per_degree;
    bool ldr = false, hdr = false, as_json = false;
};

/// How far a measure may go.
struct Tolerance {
    const Measure *measure;
    double value;
};

std::string names_of_measures() {
    std::string names;
    for (const Measure &measure : measures()) names += (names.empty() ? "" : ", ") + std::string(measure.name);
    return names;
}

const Measure &measure_named(const std::string &name) {
    for (const Measure &measure : measures())
        if (measure.name == name) return measure;
    throw CLI::ValidationError("--tolerance", "there is no measure '" + name + "', only " + names_of_measures());
}

Tolerance parse_tolerance(const std::string &text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) throw CLI::ValidationError("--tolerance", "expected MEASURE=VALUE, got '" + text + "'");
    const Measure &measure = measure_named(text.substr(0, equals));
    double value = 0;
    if (!CLI::detail::lexical_cast(text.substr(equals + 1), value) || !std::isfinite(value))
        throw CLI::ValidationError("--tolerance",
                                   "expected a number after '" + text.substr(0, equals + 1) + "', got '" + text.substr(equals + 1) + "'");
    return {&measure, value};
}

/// Those asked for. Where there are any, no pixel may be NaN or infinite unless that is asked for too.
std::vector<Tolerance> parse_tolerances(const std::vector<std::string> &texts) {
    std::vector<Tolerance> tolerances;
    for (const std::string &text : texts) tolerances.push_back(parse_tolerance(text));
    const Measure &not_finite = measure_named("not_finite");
    const bool given = std::any_of(tolerances.begin(), tolerances.end(), [&](const Tolerance &t) { return t.measure == &not_finite; });
    if (!texts.empty() && !given) tolerances.push_back({&not_finite, 0});
    return tolerances;
}

std::vector<Tolerance> broken(const std::vector<Tolerance> &tolerances, const Comparison &comparison) {
    std::vector<Tolerance> broken;
    for (const Tolerance &tolerance : tolerances) {
        const std::optional<double> value = tolerance.measure->value(comparison);
        if (!value)
            throw SceneError(fmt::format("{} has no value for so small pictures, so it cannot be held to a tolerance", tolerance.measure->name));
        if (tolerance.measure->of_likeness ? *value < tolerance.value : *value > tolerance.value) broken.push_back(tolerance);
    }
    return broken;
}

/// LDR if both files store encoded values, unless an option says what.
DynamicRange common_range(const Options &options, const Picture &test, const Picture &reference) {
    if (options.ldr || options.hdr) return options.ldr ? DynamicRange::ldr : DynamicRange::hdr;
    return test.encoded && reference.encoded ? DynamicRange::ldr : DynamicRange::hdr;
}

/// Errors about both pictures name both.
PicturePair paired(const Options &options, const Picture &test, const Picture &reference) {
    try {
        return pair_pictures(test, reference, common_range(options, test, reference));
    } catch (const SceneError &error) {
        throw SceneError(fmt::format("{}, {}: {}", options.test, options.reference, error.what()));
    }
}

json triple(const glm::dvec3 &v) { return {v.x, v.y, v.z}; }

/// The output of --json: names are a promise. What is infinite or has no value is null.
json as_json(const Options &options, const PicturePair &pair, const Comparison &comparison) {
    const auto &[pixels, ssim, flip, not_finite] = comparison;
    json all = {
        {"test", options.test},
        {"reference", options.reference},
        {"width", pair.width},
        {"height", pair.height},
        {"range", pair.range == DynamicRange::hdr ? "hdr" : "ldr"},
        {"psnr_peak", pixels.peak},
        {"pixels_per_degree", options.pixels_per_degree},
        {"max_error_at", {{"x", pixels.max_error.x}, {"y", pixels.max_error.y}, {"channel", std::string(1, "rgb"[pixels.max_error.channel])}}},
        {"worst_block_at",
         {{"x", pixels.worst_block.x}, {"y", pixels.worst_block.y}, {"width", pixels.worst_block.width}, {"height", pixels.worst_block.height}}},
        {"means", {{"test", triple(pixels.test_mean)}, {"reference", triple(pixels.reference_mean)}}},
        {"not_finite", {{"test", pair.test_not_finite}, {"reference", pair.reference_not_finite}}}};
    for (const Measure &measure : measures()) {
        const std::optional<double> value = measure.value(comparison);
        all["measures"][measure.name] = value && std::isfinite(*value) ? json(*value) : json();
    }
    if (pair.range == DynamicRange::hdr)
        all["flip_exposures"] = {{"start", flip.exposures.start}, {"stop", flip.exposures.stop}, {"count", flip.exposures.count}};
    return all;
}

std::string mean_line(const char *name, const glm::dvec3 &mean) {
    return fmt::format("mean of {:<5} {:.6g} {:.6g} {:.6g}\n", name, mean.x, mean.y, mean.z);
}

std::string as_text(const Options &options, const PicturePair &pair, const Comparison &comparison) {
    const auto &[pixels, ssim, flip, not_finite] = comparison;
    std::string text = fmt::format("a: {}\nb: {} (the reference)\n{} x {} pixels, {}\n\n", options.test, options.reference, pair.width, pair.height,
                                   pair.range == DynamicRange::hdr ? "HDR: linear values" : "LDR: sRGB-encoded values from 0 to 1");
    for (const Measure &measure : measures()) {
        const std::optional<double> value = measure.value(comparison);
        text += fmt::format("{:<12}{:<13} {}\n", measure.name, value ? fmt::format("{:.6g}", *value) : "-", measure.meaning);
    }
    text += fmt::format("\npeak of psnr: {:.6g}\n", pixels.peak);
    if (flip.exposures.count)
        text += fmt::format("exposures of flip: {} from {:.6g} to {:.6g} EV\n", flip.exposures.count, flip.exposures.start, flip.exposures.stop);
    text += fmt::format("max_error: at pixel ({}, {}), channel {}\n", pixels.max_error.x, pixels.max_error.y, "rgb"[pixels.max_error.channel]);
    text += fmt::format("worst_block: {} x {} pixels from ({}, {})\n", pixels.worst_block.width, pixels.worst_block.height, pixels.worst_block.x,
                        pixels.worst_block.y);
    if (not_finite) text += fmt::format("not_finite: {} of a, {} of b\n", pair.test_not_finite, pair.reference_not_finite);
    return text + mean_line("a:", pixels.test_mean) + mean_line("b:", pixels.reference_mean);
}

/// The map of FLIP in colours; pixels left out are green, which no difference is.
Picture difference_picture(const PicturePair &pair, const Flip &flip) {
    Picture picture{pair.width, pair.height, {}, {}};
    for (std::size_t i = 0; i < flip.map.size(); ++i) picture.pixels.push_back(pair.finite[i] ? heat_colour(flip.map[i]) : vec3(0, 1, 0));
    return picture;
}

int run(const Options &options) {
    const std::vector<Tolerance> tolerances = parse_tolerances(options.tolerances);
    if (!options.diff.empty()) DistinctFiles({options.test, options.reference}).add_output("--diff", options.diff);
    const Picture test = read_picture(options.test), reference = read_picture(options.reference);
    if (!options.diff.empty()) check_picture_writable(options.diff, test.width, test.height);
    const PicturePair pair = paired(options, test, reference);
    const Comparison comparison = compare(pair, options.pixels_per_degree);
    const std::vector<Tolerance> beyond = broken(tolerances, comparison);
    if (!options.diff.empty()) write_picture(options.diff, difference_picture(pair, comparison.flip));
    print_result(options.as_json ? as_json(options, pair, comparison).dump(2) + "\n" : as_text(options, pair, comparison));
    for (const Tolerance &tolerance : beyond)
        std::cerr << fmt::format("beyond tolerance: {} is {:.6g}, {} {:g}\n", tolerance.measure->name, *tolerance.measure->value(comparison),
                                 tolerance.measure->of_likeness ? "less than" : "more than", tolerance.value);
    return beyond.empty() ? 0 : beyond_tolerance;
}

}  // namespace

void add_compare(CLI::App &app, int &status) {
    CLI::App *command = app.add_subcommand("compare", "measure how far a picture is from its reference: " + names_of_measures());
    auto options = std::make_shared<Options>();
    command->add_option("test", options->test, "picture under test: integers are taken as sRGB-encoded (LDR), floats as linear (HDR)")->required();
    command->add_option("reference", options->reference, "its reference")->required();
    command->add_option("--diff", options->diff, "write a picture of what FLIP says of each pixel, from black (no difference) to light yellow");
    command
        ->add_option("--tolerance", options->tolerances,
                     "MEASURE=VALUE, may be given for several measures: exit with 3 if one is beyond, that is, greater (psnr and ssim: less); pixels "
                     "that are NaN or infinite are then allowed only by not_finite=COUNT")
        ->expected(1)
        ->take_all();
    CLI::Option *ldr = command->add_flag("--ldr", options->ldr, "compare what is shown: sRGB-encoded values from 0 to 1 (default for integers)");
    command->add_flag("--hdr", options->hdr, "compare linear light (default if one picture stores floats)")->excludes(ldr);
    command->add_option("--ppd", options->pixels_per_degree, "pixels per degree of the eye's view, for FLIP")
        ->check(numbers([](double x) { return x >= min_pixels_per_degree && x <= max_pixels_per_degree; },
                        fmt::format("from {:g} to {:g}", min_pixels_per_degree, max_pixels_per_degree), "NUMBER"))
        ->capture_default_str();
    command->add_flag("--json", options->as_json, "print JSON");
    command->callback([options, &status] { status = run(*options); });
}

}  // namespace brandung
