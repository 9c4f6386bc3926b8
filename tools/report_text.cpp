#include "tools/report_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace brandung {
namespace {

using nlohmann::json;

/// " (2 spheres, 4 triangles)"; nothing of none.
std::string kinds_text(const json &contents, const char *name) {
    std::string text;
    if (contents.contains(name))
        for (const auto &[kind, count] : contents[name].items()) text += (text.empty() ? " (" : ", ") + counted(count, kind);
    return text.empty() ? "" : text + ")";
}

}  // namespace

std::string counted(std::uint64_t count, std::string noun) {
    std::replace(noun.begin(), noun.end(), '_', ' ');
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : noun.ends_with("sh") ? "es" : "s");
}

std::string bytes_text(std::uint64_t bytes) { return fmt::format("{:.1f} MiB ({} bytes)", mebibytes(bytes), bytes); }

std::string contents_text(const json &contents) {
    const auto count = [&](const char *name, const char *noun) { return counted(contents[name], noun); };
    const std::string instances = contents["instances"] == 0 ? "" : ", " + count("instances", "instance") + " of " + count("groups", "group");
    return count("primitives", "primitive") + kinds_text(contents, "kinds") + ", " + count("lights", "light") + kinds_text(contents, "light_kinds") +
           ", " + count("materials", "material") + ", " + count("cameras", "camera") + instances;
}

std::string warnings_text(const std::map<std::string, uint> &warnings, const std::map<std::string, std::string> &places) {
    std::string text;
    for (const auto &[warning, count] : warnings) {
        const auto place = places.find(warning);
        const std::string times = count > 1 ? fmt::format("{} times", count) : "", at = place == places.end() ? "" : place->second;
        const std::string what = times.empty() ? at : at.empty() ? times : times + ", first at " + at;
        text += "warning: " + warning + (what.empty() ? "" : " (" + what + ")") + "\n";
    }
    return text;
}

}  // namespace brandung
