/// What `brandung bench accelerators` gives: JSON and a table.
#pragma once
#include <nlohmann/json.hpp>

#include "tools/bench/accelerators.h"

namespace brandung {

/// One row; names are a promise. What was not measured is null.
nlohmann::json accelerator_json(const AcceleratorRow &row);
/// A line of titles, and one for each row of the list.
std::string accelerators_text(const nlohmann::json &rows);

}  // namespace brandung
