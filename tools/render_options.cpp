#include "tools/render_options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

#include "tools/numbers.h"

namespace brandung {
namespace {

/// One name per file, however it is spelt; the spelling itself where the system does not tell.
std::filesystem::path canonical_name(const std::string &file) {
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::absolute(file, error);
    const std::filesystem::path canonical = error ? absolute : std::filesystem::weakly_canonical(absolute, error);
    return error ? std::filesystem::path(file) : canonical;
}

}  // namespace

void add_render_options(CLI::App &command, RenderCommandOptions &options) {
    add_scene_options(command, options);
    add_output_options(command, options.outputs);
    command.add_option("--save-every", options.save_every, "while rendering write the pictures so far every so many seconds")
        ->check(numbers([](double x) { return x > 0 && std::isfinite(x); }, "a finite number of seconds above 0", "SECONDS"));
    command.add_option("--turntable", options.turntable, "render so many pictures, the camera going once around what it looks at: NAME_000.png, ...")
        ->check(CLI::Range(1u, 1000u));
    command.add_option("--stats", options.stats, "write everything counted and timed to this JSON file");
    command
        .add_option("--preview", options.previews,
                    "show the growing picture: tev[:HOST:PORT] in the viewer tev (default 127.0.0.1:14158), web[:PORT] on a page for browsers on "
                    "this machine (default 8080, 0 for any free port); several allowed")
        ->expected(1)
        ->take_all();
    command.add_option("--preview-hold", options.preview_hold,
                       "seconds that the page stays after the render, or forever, until Ctrl-C (default: 2 if it is open somewhere, else 0)");
    command.add_flag("--explain", options.explain, "print what the scene needs and what was skipped");
    command.add_flag("--quiet", options.quiet, "no progress");
}

void check_distinct(const RenderCommandOptions &options) {
    std::set<std::filesystem::path> known = {canonical_name(options.scene)};
    const auto check = [&](const char *option, const std::string &file) {
        if (!known.insert(canonical_name(file)).second) throw CLI::ValidationError(option, "'" + file + "' is the scene or another output already");
    };
    for (const std::string &output : options.outputs.files) check("--output", output);
    if (!options.stats.empty()) check("--stats", options.stats);
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
