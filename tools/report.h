/// What a render takes and did, as JSON and as text.
#pragma once
#include <nlohmann/json.hpp>

#include "tools/job.h"

namespace brandung {

/// {"primitives": 12, "triangles": 8, "groups": 0, "instances": 0, "lights": 1, "materials": 2, "cameras": 1, "kinds": {"sphere": 4, "triangle": 8}}:
/// what is in the scene.
nlohmann::json scene_contents(const Scene &scene, const CompiledScene &compiled);
/// {"used": [text, ...], "skipped": [{"name": text, "why": text}, ...]}: what the scene needs, what was skipped and why.
nlohmann::json features(const Job &job);
/// The same, one thing a line.
std::string explain(const nlohmann::json &features);
/// {"scene_bytes": ..., "texture_bytes": ..., "wave_bytes": ..., "film_bytes": ...}
nlohmann::json memory(const Job &job);
/// The fields of --stats: names are a promise. Of the times those that `seconds` knows.
nlohmann::json statistics(const Job &job, const PhaseSeconds &seconds, const RenderEnd &end);

}  // namespace brandung
