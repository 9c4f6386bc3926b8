/// What `brandung bench` gives: JSON, a table, and the comparison with an earlier one.
#pragma once
#include <nlohmann/json.hpp>

#include "tools/bench/measure.h"

namespace brandung {

/// Names are a promise.
nlohmann::json bench_json(const Job &job, uint batch, const Measurements &measurements);
std::string bench_text(const nlohmann::json &bench);
/// Per kernel: time per item against that of an earlier bench_json(). Throws SceneError if `old` lacks a number.
nlohmann::json comparison_json(const nlohmann::json &bench, const nlohmann::json &old);
/// The same of a bench that has its "comparison".
std::string comparison_text(const nlohmann::json &bench);

}  // namespace brandung
