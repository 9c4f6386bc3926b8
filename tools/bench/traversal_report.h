/// What try_traversals() has found, as JSON and as a table.
#pragma once
#include <nlohmann/json.hpp>

#include "tools/bench/traversal.h"

namespace brandung {

/// Rows of ours are added to all["rows"], of Embree to all["embree_rows"], and what is the same for them to all["scenes"].
void add_traversal_json(nlohmann::json &all, const TraversalResult &result);
std::string traversal_text(const nlohmann::json &all);

}  // namespace brandung
