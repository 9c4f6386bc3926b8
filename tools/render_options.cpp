#include "tools/render_options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/formats/limits.h"
#include "tools/distinct_files.h"
#include "tools/numbers.h"

namespace brandung {
void add_render_options(CLI::App &command, RenderCommandOptions &options) {
    add_scene_options(command, options);
    add_device_options(command, options);
    add_output_options(command, options.outputs);
    command.footer("Example:\n  brandung render scene.json -o picture.exr -o picture.png --size 800x600 --spp 64");
    command.option_defaults()->group("Picture");
    command
        .add_option("--error", options.stop.error,
                    "render until the noise is this small: until its relMSE, mean (a - b)^2 / (b^2 + 0.01), is below with a confidence of 97.5 %; "
                    "--spp is a limit then, of which there is none by default")
        ->check(numbers([](double x) { return x > 0 && std::isfinite(x); }, "a finite number above 0", "RELMSE"));
    command
        .add_option("--time", options.stop.seconds,
                    "render so long, or until every pixel has a sample; together with --error, whichever is first; of a turntable every picture")
        ->check(numbers([](double x) { return x > 0 && std::isfinite(x); }, "a finite number of seconds above 0", "SECONDS"));
    command.option_defaults()->group("Output");
    command.add_option("--save-every", options.save_every, "while rendering write the pictures so far every so many seconds")
        ->check(numbers([](double x) { return x > 0 && std::isfinite(x); }, "a finite number of seconds above 0", "SECONDS"));
    command.add_option("--turntable", options.turntable, "render so many pictures, the camera going once around what it looks at: NAME_000.png, ...")
        ->check(whole_numbers(1u, 1000u));
    command.add_option("--stats", options.stats, "write everything counted and timed to this JSON file");
    command.add_option("--trace", options.trace,
                       "write a timeline to this JSON file, for ui.perfetto.dev or chrome://tracing: launches and builds of kernels, rays that wait, "
                       "rays per second; written as the render goes, some 100 bytes for each launch, to a file NAME.*.part.json until it ends");
    command.add_flag("--explain", options.explain, "print what the scene needs and what was skipped");
    command.add_flag("--quiet", options.quiet, "no progress, only warnings");
    command.option_defaults()->group("Preview");
    command
        .add_option("--preview", options.previews,
                    "show the growing picture: tev[:HOST:PORT] in the viewer tev (default 127.0.0.1:14158), web[:PORT] on a page for browsers on "
                    "this machine (default 8080, 0 for any free port); several allowed")
        ->expected(1)
        ->take_all();
    command.add_option("--preview-hold", options.preview_hold,
                       "seconds that the page stays after the render, or forever, until Ctrl-C (default: 2 if it is open somewhere, else 0)");
}

void lift_limit_of_samples(RenderCommandOptions &options) {
    const auto limits = [](const std::string &setting) { return setting.starts_with("film.spp="); };
    if (!(options.stop.error || options.stop.seconds) || std::any_of(options.settings.begin(), options.settings.end(), limits)) return;
    if (!options.spp) options.spp = max_samples;
}

void check_distinct(const RenderCommandOptions &options, const Scene &scene) {
    DistinctFiles files(scene.files);
    for (uint picture = 0; picture < options.pictures(); ++picture)
        for (const std::string &output : options.outputs_of(picture).files) files.add_output("--output", output);
    if (!options.stats.empty()) files.add_output("--stats", options.stats);
    if (!options.trace.empty()) files.add_output("--trace", options.trace);
}

std::vector<PreviewTarget> preview_targets(const RenderCommandOptions &options) {
    std::vector<PreviewTarget> targets;
    for (const std::string &preview : options.previews) targets.push_back(read_preview_target(preview));
    return targets;
}

std::optional<double> hold_seconds(const RenderCommandOptions &options) {
    const std::string &text = options.preview_hold;
    if (text.empty()) return std::nullopt;
    if (std::none_of(options.previews.begin(), options.previews.end(), [](const std::string &preview) { return preview.starts_with("web"); }))
        throw CLI::ValidationError("--preview-hold", "there is no --preview web");
    double seconds = std::numeric_limits<double>::infinity();
    if (text != "forever" && !(CLI::detail::lexical_cast(text, seconds) && seconds >= 0 && std::isfinite(seconds)))
        throw CLI::ValidationError("--preview-hold", "expected seconds or forever, got '" + text + "'");
    return seconds;
}

}  // namespace brandung
