#include "tools/scene_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "scene/accelerators/accelerator.h"
#include "scene/error.h"
#include "scene/formats/limits.h"
#include "scene/meshes/default_view.h"
#include "scene/parameters.h"
#include "scene/tone.h"
#include "tools/numbers.h"

namespace brandung {
namespace {

constexpr uint max_threads = 65536;  ///< more than any device has compute units

/// Numbers with commas between them; nothing if the text is something else.
std::vector<float> numbers_in(const std::string &text) {
    std::vector<float> numbers;
    const char *at = text.data(), *const end = at + text.size();
    while (true) {
        const auto [stop, error] = std::from_chars(at, end, numbers.emplace_back());
        if (error != std::errc() || (stop != end && *stop != ',')) return {};
        if (stop == end) return numbers;
        at = stop + 1;
    }
}

/// #RRGGBB, by the sRGB curve.
nlohmann::json hexadecimal_color(const std::string &text) {
    uint bits = 0;
    const auto [stop, error] = std::from_chars(text.data() + 1, text.data() + text.size(), bits, 16);
    if (text.size() != 7 || error != std::errc() || stop != text.data() + text.size())
        throw CLI::ValidationError("--background", "expected #RRGGBB in hexadecimal digits, got '" + text + "'");
    nlohmann::json color = nlohmann::json::array();
    for (const uint shift : {16, 8, 0}) color.push_back(srgb_decoded(float(bits >> shift & 0xff) / 255));
    return color;
}

/// The setting "background" as a colour or a picture on the command line.
nlohmann::json background_value(const std::string &text) {
    if (text.starts_with('#')) return hexadecimal_color(text);
    const std::vector<float> numbers = numbers_in(text);
    if (!std::all_of(numbers.begin(), numbers.end(), [](float x) { return std::isfinite(x); }))
        throw CLI::ValidationError("--background", "expected finite numbers, got '" + text + "'");
    if (numbers.size() == 1) return numbers[0];
    if (numbers.size() == 3) return numbers;
    if (!numbers.empty()) throw CLI::ValidationError("--background", "expected one number or three, got '" + text + "'");
    if (!std::filesystem::path(text).has_extension())
        throw CLI::ValidationError("--background", "expected a colour, as #RRGGBB, R,G,B or one number, or a picture's file, got '" + text + "'");
    return {{"image", std::filesystem::absolute(text).string()}};
}

/// The options that stand for settings of the scene file, after those that are given as such, and before those that are varied.
std::vector<std::string> assignments(const SceneOptions &options) {
    std::vector<std::string> all = options.settings;
    const auto add = [&](const char *key, const std::string &value) { all.push_back(std::string(key) + "=" + value); };
    if (!options.size.empty()) {
        const auto cross = options.size.find('x');
        if (cross == std::string::npos) throw CLI::ValidationError("--size", "expected WIDTHxHEIGHT, got '" + options.size + "'");
        add("film.width", options.size.substr(0, cross)), add("film.height", options.size.substr(cross + 1));
    }
    if (options.spp) add("film.spp", std::to_string(*options.spp));
    if (options.seed) add("film.seed", std::to_string(*options.seed));
    if (!options.pixel.empty()) add("film.pixel", options.pixel);
    if (!options.sampler.empty()) add("film.sampler", options.sampler);
    if (!options.crop.empty()) add("film.crop", "[" + options.crop + "]");
    if (!options.aovs.empty()) add("film.aovs", "[\"" + fmt::format("{}", fmt::join(options.aovs, "\",\"")) + "\"]");
    if (!options.exposure.empty()) add("film.exposure", options.exposure);
    if (!options.tone.empty()) add("film.tone", options.tone);
    if (!options.filter.empty()) add("film.filter", options.filter);
    if (options.max_depth) add("integrator.max_depth", std::to_string(*options.max_depth));
    if (options.light_samples) add("integrator.light_samples", std::to_string(*options.light_samples));
    for (const std::string &bundle : options.bundles) {
        if (bundle.find('=') == std::string::npos) throw CLI::ValidationError("--bundles", "expected KIND=SIZE, got '" + bundle + "'");
        all.push_back("integrator.bundles." + bundle);
    }
    if (!options.follow.empty()) add("integrator.follow", options.follow);
    if (!options.shadows.empty()) add("integrator.shadows", options.shadows);
    if (!options.integrator.empty()) add("integrator.type", options.integrator);
    if (!options.accelerator.empty()) add("accelerator", options.accelerator);
    if (!options.accelerator_quality.empty()) add("accelerator_quality", options.accelerator_quality);
    if (!options.background.empty())
        add("background", background_value(options.background).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    all.insert(all.end(), options.varied.begin(), options.varied.end());
    return all;
}

/// Three numbers with commas between them; nothing of an empty text.
std::optional<vec3> vector_option(const char *option, const std::string &text) {
    if (text.empty()) return {};
    const std::vector<float> numbers = numbers_in(text);
    if (numbers.size() != 3 || std::any_of(numbers.begin(), numbers.end(), [](float x) { return !(std::abs(double(x)) <= max_magnitude); }))
        throw CLI::ValidationError(option, "expected three numbers as X,Y,Z, got '" + text + "'");
    return vec3(numbers[0], numbers[1], numbers[2]);
}

ViewChanges view_changes(const SceneOptions &options) {
    ViewChanges changes{vector_option("--from", options.from), vector_option("--at", options.at), vector_option("--up", options.up), {}};
    if (options.fov) changes.fov = glm::radians(*options.fov);
    return changes;
}

std::string names_of_accelerators() {
    std::vector<const char *> names;
    for (const AcceleratorKind &kind : accelerator_kinds()) names.push_back(kind.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

void add_any_setting(CLI::App &command, SceneOptions &options) {
    command.option_defaults()->group("Scene");
    command
        .add_option("--set", options.settings,
                    "any setting of the scene file, as KEY=VALUE: the key with dots and numbers (integrator.threshold, objects.0.radius), the value "
                    "as in JSON")
        ->expected(1)
        ->take_all();
}

void add_picture_options(CLI::App &command, SceneOptions &options) {
    command.option_defaults()->group("Picture");
    command.add_option("--size", options.size, "picture size as WIDTHxHEIGHT (default: the scene's, or 512x512)");
    command.add_option("--crop", options.crop,
                       "the part of the picture to render as X0,Y0,X1,Y1: pixels from the left and the top, X1 and Y1 exclusive");
    command.add_option("--spp", options.spp, fmt::format("samples per pixel (default: the scene's, or 1; of a mesh file {})", mesh_spp))
        ->check(whole_numbers(1u, max_samples));
    command.add_option("--seed", options.seed, "seed of random numbers")->check(whole_numbers(0u, 0xffffffffu));
    command.add_option("--pixel", options.pixel, "where a single sample lies: corner, center or random");
    command.add_option("--sampler", options.sampler,
                       "where more samples than one lie: sobol, independent, stratified or blue_noise (default: the scene's)");
    command.add_option("--filter", options.filter, "how samples count in their pixel: box, tent, gaussian, mitchell or blackman_harris");
    command
        .add_option("--aov", options.aovs,
                    "further channels of EXR: normal, albedo, depth, position, primitive, instance, samples, error or all; several as normal,albedo")
        ->delimiter(',')
        ->expected(1)
        ->take_all();
    command.add_option("--exposure", options.exposure,
                       "of pictures of integers in EV, or auto: the median luminance of pixels that are not black becomes middle grey (of a "
                       "turntable, in its first picture)");
    command.add_option("--tone", options.tone, "curve of pictures of integers: srgb, filmic or none");
}

void add_view_options(CLI::App &command, SceneOptions &options) {
    command.option_defaults()->group("Camera and background");
    command.add_option("--camera", options.camera, "name of the scene's camera to use (default: the first)");
    command.add_option("--from", options.from, "position of the eye as X,Y,Z (default: the camera's; a mesh gets a camera that sees all of it)");
    command.add_option("--at", options.at, "a point in the middle of the picture, as X,Y,Z");
    command.add_option("--up", options.up, "what is up in the picture, as X,Y,Z: 0,0,1 for meshes that stand on the xy plane");
    command.add_option("--fov", options.fov, "vertical angle of view [degrees]")
        ->check(numbers([](double x) { return float(x) > 0 && float(x) <= 360; }, "above 0 and at most 360 degrees", "DEGREES"));
    command.add_option("--background", options.background,
                       "what rays see that leave the scene: a colour, as R,G,B or one number (linear) or #RRGGBB (sRGB), or a latitude-longitude "
                       "picture, whose middle lies in -z and whose upper edge in y");
}

void add_light_options(CLI::App &command, SceneOptions &options) {
    command.option_defaults()->group("Light");
    command.add_option("--integrator", options.integrator, "how light gets to the eye (default: the scene's)");
    command.add_option("--max-depth", options.max_depth, "rays in a chain, the eye ray being 1 (default: the scene's, or 5)")
        ->check(whole_numbers(1u, max_depth));
    command
        .add_option(
            "--light-samples", options.light_samples,
            fmt::format("K: every emissive surface lights others from K x K of its points, but for paths, which ask one light at a surface; 0: "
                        "from none (default: the scene's, or 1; of a mesh file {})",
                        mesh_light_samples))
        ->check(whole_numbers(0u, MAX_LIGHT_SAMPLES));
    command
        .add_option("--bundles", options.bundles,
                    "of integrator distributed: how many rays the surface sends that the eye sees, by what they are for: light, diffuse, glossy, "
                    "transmission; several as light=16,glossy=4 (default: the scene's, or 4 each)")
        ->delimiter(',')
        ->expected(1)
        ->take_all();
    command.add_option("--follow", options.follow,
                       "of rays reflected and refracted by one surface: both, or one, chosen at random (default: the scene's)");
    command.add_option("--shadows", options.shadows, "of transparent objects: opaque, or filtered, which lets light through (default: the scene's)");
}

}  // namespace

void add_scene_options(CLI::App &command, SceneOptions &options) {
    command.option_defaults()->group("Scene");
    command.add_option("scene", options.scene, "scene file: .json (native), .nff, or a mesh: .obj, .ply")->required();
    command.add_option("--accelerator", options.accelerator, fmt::format("{} or auto (default: the scene's)", names_of_accelerators()));
    add_scene_settings(command, options);
}

void add_scene_settings(CLI::App &command, SceneOptions &options) {
    add_any_setting(command, options);
    command.add_option("--accelerator-quality", options.accelerator_quality,
                       "how wide_bvh is built: fast, or high, which takes longer and makes rays faster (default: the scene's, or fast)");
    add_picture_options(command, options);
    add_view_options(command, options);
    add_light_options(command, options);
    command.option_defaults()->group("Options");
}

void add_device_options(CLI::App &command, SceneOptions &options) {
    command.option_defaults()->group("Device");
    command.add_option("--device", options.device, "OpenCL device whose name contains this");
    command.add_flag("--untrusted-device", options.untrusted_device,
                     "take the device even if brandung selftest has found that it may not be trusted");
    command.add_option("--batch", options.batch, "rays per wave")->check(whole_numbers(1u, 1u << 24))->capture_default_str();
    command.add_option("--threads", options.threads, "compute units to use of a CPU (default: all, as 0)")->check(whole_numbers(0u, max_threads));
    command.option_defaults()->group("Options");
}

Scene read_scene(const SceneOptions &options, const ReadProgress &progress) {
    return read_scene(options.scene, {assignments(options), view_changes(options), progress, options.keep_places});
}

const CameraDescription &chosen_camera(const Scene &scene, const std::string &name) {
    for (const CameraDescription &camera : scene.cameras)
        if (name.empty() || camera.name == name) return camera;
    std::string names;
    for (const CameraDescription &camera : scene.cameras) names += (names.empty() ? "" : ", ") + ("'" + camera.name + "'");
    throw SceneError(scene.file + ": there is no camera '" + name + "', only " + names);
}

}  // namespace brandung
