#include "tools/bench/growth_report.h"

#include <fmt/format.h>

#include <cmath>

#include "tools/median.h"

namespace brandung {
namespace {

using nlohmann::json;

constexpr const char *fitted[] = {"build_seconds", "N_TS", "tests", "closest_nanoseconds", "any_nanoseconds"};

json row_json(const GrowthRow &row) {
    const WorkSums &work = row.closest.work;
    const auto per_ray = [&](std::uint64_t sum) { return double(sum) / double(row.rays); };
    return {{"scene", row.scene},
            {"accelerator", row.accelerator},
            {"objects", row.objects},
            {"rays", row.rays},
            {"build_seconds", row.build_seconds},
            {"bytes_per_object", double(row.bytes) / row.objects},
            {"hits", work.hits},
            {"N_TS", per_ray(work.steps)},
            {"N_IT", per_ray(work.listed > 0 ? work.listed : work.tests)},
            {"tests", per_ray(work.tests)},
            {"tests_made", per_ray(BLOCK_SIZE * work.blocks)},
            {"any_N_TS", per_ray(row.any.work.steps)},
            {"any_tests", per_ray(row.any.work.tests)},
            {"closest_nanoseconds", 1e9 * median(row.closest.seconds) / double(row.rays)},
            {"any_nanoseconds", 1e9 * median(row.any.seconds) / double(row.rays)}};
}

/// The slope of the straight line through the logarithms, by least squares; null of less than two different numbers.
json slope(const std::vector<const json *> &rows, const std::string &name) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const json *row : rows) {
        if (!((*row)[name].get<double>() > 0)) continue;
        const double at = std::log(row->at("objects").get<double>()), value = std::log(row->at(name).get<double>());
        n += 1, x += at, y += value, xx += at * at, xy += at * value;
    }
    const double spread = n * xx - x * x;
    return spread > 1e-9 ? json((n * xy - x * y) / spread) : json();
}

/// Of one accelerator of one scene, over its largest two decades of objects.
json exponents(const json &rows, const std::string &scene, const std::string &accelerator) {
    std::vector<const json *> own;
    double most = 0;
    for (const json &row : rows)
        if (row["scene"] == scene && row["accelerator"] == accelerator) own.push_back(&row), most = std::max(most, row["objects"].get<double>());
    std::erase_if(own, [&](const json *row) { return (*row)["objects"].get<double>() < most / 100; });
    json all = {{"scene", scene}, {"accelerator", accelerator}};
    for (const char *name : fitted) all[name] = slope(own, name);
    return all;
}

std::string row_line(const json &row) {
    const auto number = [&](const char *name) { return row[name].get<double>(); };
    return fmt::format("{:<10}{:>9} {:<17}{:>9.4f}{:>9.1f}{:>10.2f}{:>11.2f}{:>11.2f}{:>11.2f}{:>11.0f}{:>11.0f}\n", row["scene"].get<std::string>(),
                       row["objects"].get<uint>(), row["accelerator"].get<std::string>(), number("build_seconds"), number("bytes_per_object"),
                       number("N_TS"), number("N_IT"), number("tests"), number("tests_made"), number("closest_nanoseconds"),
                       number("any_nanoseconds"));
}

std::string exponents_line(const json &row) {
    std::string text = fmt::format("{:<10}{:<17}", row["scene"].get<std::string>(), row["accelerator"].get<std::string>());
    for (const char *name : fitted) text += row[name].is_null() ? fmt::format("{:>11}", "-") : fmt::format("{:>11.2f}", row[name].get<double>());
    return text + "\n";
}

}  // namespace

json growth_json(const Growth &growth) {
    json rows = json::array(), all_exponents = json::array();
    for (const GrowthRow &row : growth.rows) rows.push_back(row_json(row));
    std::vector<std::pair<std::string, std::string>> seen;
    for (const GrowthRow &row : growth.rows) {
        const std::pair one(row.scene, row.accelerator);
        if (std::find(seen.begin(), seen.end(), one) != seen.end()) continue;
        seen.push_back(one);
        all_exponents.push_back(exponents(rows, row.scene, row.accelerator));
    }
    return {{"rows", rows}, {"exponents", all_exponents}, {"notes", growth.notes}};
}

std::string growth_text(const json &all) {
    std::string text = fmt::format("{:<10}{:>9} {:<17}{:>9}{:>9}{:>10}{:>11}{:>11}{:>11}{:>11}{:>11}\n", "scene", "objects", "accelerator", "build s",
                                   "B/object", "N_TS", "N_IT", "tests", "tests made", "ns/closest", "ns/any");
    for (const json &row : all["rows"]) text += row_line(row);
    text += fmt::format("\n{:<27}{:>11}{:>11}{:>11}{:>11}{:>11}\n", "exponent of objects", "build s", "N_TS", "tests", "ns/closest", "ns/any");
    for (const json &row : all["exponents"]) text += exponents_line(row);
    for (const json &note : all["notes"]) text += note.get<std::string>() + "\n";
    return text;
}

}  // namespace brandung
