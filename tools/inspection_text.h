/// An inspected pixel as text.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace brandung {

/// Of what inspection_json() gives: per sample its tree, a line per ray, then unless it is to be brief all that is known of each ray.
std::string inspection_text(const nlohmann::json &inspection, bool brief);

}  // namespace brandung
