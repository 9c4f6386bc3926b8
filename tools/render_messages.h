/// What brandung render says on standard error beside its progress.
#pragma once
#include "tools/preview/preview.h"
#include "tools/progress.h"
#include "tools/render_options.h"

namespace brandung {

/// Throws Error with the sizes of a render that is too big for its device.
void check_memory(const Job &job);

void print_warnings(const RenderCommandOptions &options, const Job &job);
/// What was chosen where the scene says nothing, and what the render will take.
void print_plan(const Job &job, const StopRules &stop);
/// How much noise the picture has, if that is known, and what makes it wrong beyond that; `prefix`: which picture.
void print_noise(const Job &job, const RenderEnd &end, const std::string &prefix);
/// That the noise is not below what the rules want, if so.
void print_missed_error(const RenderEnd &end, const StopRules &stop, const std::string &prefix);
/// What the picture has lost.
void print_losses(const Job &job);
/// Viewers that have gone away since the last time.
void print_faults(Preview &preview, ProgressLine &progress);

}  // namespace brandung
