/// Provenance: what a result was made from, and by what.
#pragma once
#include <map>
#include <string>

#include "tools/job.h"

namespace brandung {

/// "brandung 1.0 (commit)"
std::string program_version();
/// Sizes of bundles of rays, as --bundles takes them.
std::string text_of(const Bundles &bundles);
/// Of what the scene contains, however it is rendered, in hexadecimal digits.
std::string scene_fingerprint(const Job &job);
/// All settings that decide radiance but for samples, as in metadata of pictures: {"sampler": "sobol", "max_depth": "5", ...}; "crop" is the whole
/// picture where a scene has none.
std::map<std::string, std::string> settings_of(const Job &job);

}  // namespace brandung
