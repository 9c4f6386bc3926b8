#include "tools/converge/foreign_series.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scene/error.h"

namespace brandung {
namespace {

using nlohmann::json;

/// A number of an entry; `fallback` where there is none, which is an error if it is negative.
double number(const json &entry, const char *key, double fallback, const std::string &place) {
    if (!entry.contains(key) && fallback >= 0) return fallback;
    if (!entry.contains(key) || !entry[key].is_number() || !(entry[key].get<double>() >= 0))
        throw SceneError(fmt::format("{}: \"{}\" must be a number of at least 0", place, key));
    return entry[key].get<double>();
}

json read_times(const std::string &file) {
    std::ifstream in(file);
    if (!in) throw SceneError(file + ": no such file");
    json times = json::parse(in, nullptr, false);
    if (!times.is_array() || times.empty()) throw SceneError(file + ": must be a list of {\"file\": ..., \"seconds\": ...}");
    return times;
}

}  // namespace

Series read_foreign_series(const std::string &name, const std::string &folder, const Picture &reference) {
    const std::string file = (std::filesystem::path(folder) / "times.json").string();
    Series series{name, {}};
    std::map<double, std::size_t> rungs;  // by samples, or by seconds where these are not told
    std::size_t place = 0;
    for (const json &entry : read_times(file)) {
        const std::string where = fmt::format("{}: /{}", file, place++);
        if (!entry.is_object() || !entry.contains("file") || !entry["file"].is_string())
            throw SceneError(where + ": must be an object with a \"file\"");
        const double seconds = number(entry, "seconds", -1, where), samples = number(entry, "samples", 0, where);
        const double rung = number(entry, "rung", samples > 0 ? samples : seconds, where);
        const std::string picture = (std::filesystem::path(folder) / entry["file"].get<std::string>()).string();
        series.runs.push_back({rungs.try_emplace(rung, rungs.size()).first->second, static_cast<uint>(number(entry, "seed", 0, where)), samples,
                               seconds, errors_of(read_picture(picture), reference)});
    }
    return series;
}

}  // namespace brandung
