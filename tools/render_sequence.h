/// The pictures of a render, one after another: a turntable's, or one.
#pragma once
#include <utility>

#include "tools/preview/preview.h"
#include "tools/progress.h"
#include "tools/render_options.h"
#include "tools/trace.h"

namespace brandung {

/// Renders and writes the pictures one after another, each from a camera turned further. The first one's exposure is that of all.
/// `trace` may be null. Gives the end of them all, and that exposure.
std::pair<RenderEnd, float> render_pictures(const RenderCommandOptions &options, Job &job, PhaseSeconds &seconds, Preview &preview, Trace *trace,
                                            ProgressLine &progress);

}  // namespace brandung
