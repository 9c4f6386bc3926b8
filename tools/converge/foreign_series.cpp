#include "tools/converge/foreign_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "scene/error.h"
#include "tools/json_file.h"

namespace brandung {
namespace {

using nlohmann::json;

/// An entry of times.json, and its place for errors.
struct Entry {
    const json &values;
    std::string place;

    [[noreturn]] void fail(const char *key, const std::string &what) const {
        throw SceneError(fmt::format("{}/{}: {}, got {}", place, key, what, values.contains(key) ? values[key].dump() : "nothing"));
    }
    /// A finite number, at least `low` or, if `low` is 0 and must not be reached, above it.
    double number(const char *key, bool above_zero) const {
        const bool is_number = values.contains(key) && values[key].is_number();
        const double value = is_number ? values[key].get<double>() : -1;
        if (!(std::isfinite(value) && (above_zero ? value > 0 : value >= 0)))
            fail(key, above_zero ? "must be a finite number above 0" : "must be a finite number of at least 0");
        return value;
    }
    std::optional<double> number_if_given(const char *key, bool above_zero) const {
        return values.contains(key) ? std::optional(number(key, above_zero)) : std::nullopt;
    }
    uint seed() const {
        constexpr uint largest = std::numeric_limits<uint>::max();
        if (!values.contains("seed")) return 0;
        const json &seed = values["seed"];
        if (!seed.is_number_unsigned() || seed.get<std::uint64_t>() > largest)
            fail("seed", fmt::format("must be a whole number from 0 to {}", largest));
        return seed.get<uint>();
    }
    std::string file() const {
        if (!values.is_object()) throw SceneError(place + ": must be an object with a \"file\" and \"seconds\"");
        if (!values.contains("file") || !values["file"].is_string()) fail("file", "must be the name of a picture");
        return values["file"].get<std::string>();
    }
};

json read_times(const std::string &file) {
    json times = read_json(file);
    if (!times.is_array() || times.empty()) throw SceneError(file + ": must be a list of {\"file\": ..., \"seconds\": ...}");
    return times;
}

void check_size(const std::string &file, uint width, uint height) {
    const Picture picture = read_picture(file);
    if (picture.width != width || picture.height != height)
        throw SceneError(fmt::format("{}: has {} x {} pixels, not {} x {}", file, picture.width, picture.height, width, height));
}

}  // namespace

ForeignSeries read_foreign_series(const std::string &name, const std::string &folder, uint width, uint height) {
    const std::filesystem::path path(folder);
    const std::string file = (path / "times.json").string();
    const json times = read_times(file);
    ForeignSeries foreign{{name, {}}, {}};
    std::vector<double> order;  // of runs, by which they make rungs
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Entry entry{times[i], fmt::format("{}: /{}", file, i)};
        foreign.pictures.push_back((path / entry.file()).string());
        const double seconds = entry.number("seconds", true);
        const std::optional<double> samples = entry.number_if_given("samples", true), rung = entry.number_if_given("rung", false);
        order.push_back(rung.value_or(samples.value_or(seconds)));
        foreign.series.runs.push_back({0, entry.seed(), samples.value_or(0), seconds, {}});
        check_size(foreign.pictures.back(), width, height);
    }
    std::vector<double> rungs = order;
    std::sort(rungs.begin(), rungs.end());
    rungs.erase(std::unique(rungs.begin(), rungs.end()), rungs.end());
    for (std::size_t i = 0; i < order.size(); ++i)
        foreign.series.runs[i].rung = static_cast<std::size_t>(std::lower_bound(rungs.begin(), rungs.end(), order[i]) - rungs.begin());
    return foreign;
}

Series measured(ForeignSeries foreign, const Picture &reference) {
    for (std::size_t i = 0; i < foreign.pictures.size(); ++i) foreign.series.runs[i].errors = errors_of(read_picture(foreign.pictures[i]), reference);
    std::stable_sort(foreign.series.runs.begin(), foreign.series.runs.end(), [](const Run &a, const Run &b) { return a.rung < b.rung; });
    return std::move(foreign.series);
}

}  // namespace brandung
