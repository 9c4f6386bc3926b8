/// Pages that show data: built into the program with a mark where the data go.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace brandung {

/// The page, whose script has `/*DATA*/null` for them. No text in the data can end the script.
std::string page_with_data(std::string_view html, const nlohmann::json &data);

}  // namespace brandung
