/// What `brandung bench` gives: JSON and a table.
#pragma once
#include <nlohmann/json.hpp>

#include "tools/bench/measure.h"

namespace brandung {

/// What is measured, by what, and where; known before it is. Names are a promise.
nlohmann::json bench_subject(const Job &job, uint batch);
/// The same with what was measured.
nlohmann::json bench_json(const Job &job, uint batch, const Measurements &measurements);
std::string bench_text(const nlohmann::json &bench);

}  // namespace brandung
