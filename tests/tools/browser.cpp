#include "tests/tools/browser.h"

#include <cstdio>
#include <regex>

namespace {

std::string output_of(const std::string &command) {
    FILE *const pipe = popen(command.c_str(), "r");
    std::string text;
    char part[4096];
    for (std::size_t got = 0; (got = fread(part, 1, sizeof part, pipe)) > 0;) text.append(part, got);
    pclose(pipe);
    return text;
}

}  // namespace

bool has_browser() { return !output_of("command -v chromium").empty(); }

std::string page_after(const std::string &url, int milliseconds, const std::string &profile) {
    return output_of("timeout 60 chromium --headless --no-sandbox --disable-gpu --user-data-dir='" + profile +
                     "' --virtual-time-budget=" + std::to_string(milliseconds) + " --dump-dom '" + url + "' 2>/dev/null");
}

std::string text_of(const std::string &page, const std::string &id) {
    std::smatch found;
    return std::regex_search(page, found, std::regex("id=\"" + id + "\"[^>]*>([^<]*)<")) ? found[1].str() : "";
}
