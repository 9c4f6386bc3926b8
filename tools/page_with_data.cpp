#include "tools/page_with_data.h"

#include <nlohmann/json.hpp>

namespace brandung {

std::string page_with_data(std::string_view html, const nlohmann::json &data) {
    std::string page(html), safe;
    const std::string mark = "/*DATA*/null", text = data.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    for (const char c : text) safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return page.replace(page.find(mark), mark.size(), safe);
}

}  // namespace brandung
