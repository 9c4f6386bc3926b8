#include "tools/json_file.h"

#include "scene/input.h"

namespace brandung {

nlohmann::json read_json(const std::string &file) { return nlohmann::json::parse(file_text(file), nullptr, false); }

}  // namespace brandung
