/// What the self-test has found out, as text and as JSON.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/selftest/selftest.h"

namespace brandung {

/// A table with its legend: a line per subject and quantity.
std::string as_text(const DeviceInfo &device, const std::vector<SubjectReport> &reports, Outcome outcome);
/// Names are a promise.
nlohmann::json as_json(const DeviceInfo &device, const std::vector<SubjectReport> &reports, Outcome outcome);

}  // namespace brandung
