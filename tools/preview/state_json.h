/// A render's state as JSON, for its page and other programs.
#pragma once
#include <nlohmann/json.hpp>

#include "tools/preview/state.h"

namespace brandung {

/// "preparing", "rendering", "done", "interrupted" or "failed".
const char *phase_name(PreviewPhase phase);
/// Names are a promise; `rays` and `kernels` are those of --stats. What is not known yet is null.
nlohmann::json state_json(const PreviewState &state);

}  // namespace brandung
