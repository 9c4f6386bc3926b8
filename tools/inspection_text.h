/// An inspected pixel as text: a tree of rays.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace brandung {

/// Of what inspection_json() gives.
std::string inspection_text(const nlohmann::json &inspection);

}  // namespace brandung
