/// What brandung render is told.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "tools/outputs.h"
#include "tools/preview/target.h"
#include "tools/scene_options.h"

namespace brandung {

struct RenderCommandOptions : SceneOptions {
    OutputOptions outputs;
    std::string stats, trace;
    std::vector<std::string> previews;
    std::string preview_hold;
    std::optional<double> save_every;  ///< [s]
    std::optional<uint> turntable;     ///< pictures
    StopRules stop;
    uint pictures() const { return turntable.value_or(1); }
    OutputOptions outputs_of(uint picture) const { return turntable ? numbered(outputs, picture) : outputs; }
    bool explain = false, quiet = false;
};

/// Where a rule is to end the render, samples are not limited unless somebody says so.
void lift_limit_of_samples(RenderCommandOptions &options);

/// `options` must live until the command has run.
void add_render_options(CLI::App &command, RenderCommandOptions &options);

/// Of all that is written nothing may replace what is read or written too. Throws CLI::ValidationError.
void check_distinct(const RenderCommandOptions &options, const Scene &scene);
/// Throws CLI::ValidationError.
std::vector<PreviewTarget> preview_targets(const RenderCommandOptions &options);
/// Seconds that the page stays after the render; nothing where nothing is said. Throws CLI::ValidationError.
std::optional<double> hold_seconds(const RenderCommandOptions &options);

}  // namespace brandung
