/// The pictures that a render writes.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "tools/job.h"

namespace CLI {
class App;
}

namespace brandung {

struct OutputOptions {
    std::vector<std::string> files, bits;
    std::optional<uint> quality;
    std::optional<float> exposure;  ///< [EV] that has been chosen already, where it is automatic
};

/// `options` must live until the command has run.
void add_output_options(CLI::App &command, OutputOptions &options);
/// Throws SceneError if a file could not be written, and CLI::ValidationError for an option that no file has a use for.
void check_outputs(const OutputOptions &options, const FilmSettings &film);
/// Writes the film as it is now. `running`: more is going to come. Gives the exposure [EV] of pictures of integers. Throws SceneError.
float write_outputs(const OutputOptions &options, Job &job, const PhaseSeconds &seconds, const RenderEnd &end, bool running);
/// The files of one picture of a sequence: "a.png" becomes "a_007.png".
OutputOptions numbered(OutputOptions options, uint number);
/// "12 of 34 samples".
std::string samples_taken(const RenderEnd &end);

}  // namespace brandung
