/// Comparison of a bench with an earlier one of the same work.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace brandung {

/// What bench --json gave. Throws SceneError, with the file and the place in it, for anything else.
nlohmann::json read_earlier_bench(const std::string &file);
/// Throws SceneError, which says what differs, unless both measure the same work: scene, size, samples and all other settings.
void check_same_work(const nlohmann::json &subject, const nlohmann::json &earlier, const std::string &file);
/// Per kernel time per item against that of the earlier bench, which kernels only one has, and what else differs: program, device, batch, ...
nlohmann::json comparison_json(const nlohmann::json &bench, const nlohmann::json &earlier);
/// The same of a bench that has its "comparison".
std::string comparison_text(const nlohmann::json &bench);

}  // namespace brandung
