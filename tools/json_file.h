/// Files of JSON.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace brandung {

/// What a file holds; discarded, in the library's words, where that is no JSON. Throws SceneError if it cannot be read.
nlohmann::json read_json(const std::string &file);

}  // namespace brandung
