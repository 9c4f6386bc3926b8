/// What `brandung bench growth` gives: JSON, tables and a page.
#pragma once
#include <nlohmann/json.hpp>

#include "tools/bench/growth.h"

namespace brandung {

/// "rows", "exponents" and "notes"; names are a promise.
nlohmann::json growth_json(const Growth &growth);
std::string growth_text(const nlohmann::json &all);

}  // namespace brandung
