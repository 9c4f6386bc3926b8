/// What a render takes and did, as JSON and as text.
#pragma once
#include <nlohmann/json.hpp>

#include "tools/job.h"

namespace brandung {

/// {"primitives": 12, "triangles": 8, "groups": 0, "instances": 0, "lights": 1, "materials": 2, "cameras": 1, "kinds": {"sphere": 4, "triangle": 8},
/// "light_kinds": {"point": 1}}: what is in the scene.
nlohmann::json scene_contents(const Scene &scene, const CompiledScene &compiled);
/// {"camera": 12, "camera_hits": 8, ..., "total": 40}: rays, and the hits of each kind.
nlohmann::json ray_statistics(const RayCounts &counts);
/// [{"name": text, "launches": ..., "items": ..., "milliseconds": ...}, ...]
nlohmann::json kernel_statistics(const Profile &profile);
/// {"used": [text, ...], "skipped": [{"name": text, "why": text}, ...], "not_shown": [the same]}: what the scene needs, what was
/// skipped and why, and what light the integrator leaves out.
nlohmann::json features(const Job &job);
/// The same, one thing a line.
std::string explain(const nlohmann::json &features);
/// {"scene_bytes": ..., "texture_bytes": ..., "wave_bytes": ..., "film_bytes": ...}
nlohmann::json memory(const Job &job);
/// That of the accelerator in use; null if it knows but one.
nlohmann::json quality(const Job &job);
/// [{"name": text, "why": text}, ...]: what makes the picture wrong beyond noise.
nlohmann::json biases(const Job &job);
/// {"relmse": ..., "confidence_95": [low, high]}, or null.
nlohmann::json noise_statistics(const std::optional<Noise> &noise);
/// The fields of --stats: names are a promise. Of the times those that `seconds` knows.
nlohmann::json statistics(const Job &job, const PhaseSeconds &seconds, const RenderEnd &end);

}  // namespace brandung
