#include "tools/bench/comparison.h"

#include <fmt/format.h>

#include "scene/error.h"
#include "tools/json_file.h"

namespace brandung {
namespace {

using nlohmann::json;

/// What may differ between benches that are compared, and is named then.
constexpr const char *circumstances[] = {"program", "device", "driver", "compute_units", "accelerator", "batch"};
constexpr const char *numbers_of_kernels[] = {"ns_per_item_and_core", "milliseconds_low", "milliseconds_high"};

std::string text_of(const json &value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

void expect(bool holds, const std::string &file, const std::string &place, const std::string &what) {
    if (!holds) throw SceneError(fmt::format("{}: {}: {}; is it of bench --json?", file, place, what));
}

void check_number(const json &of, const char *name, const std::string &file, const std::string &place) {
    expect(of.contains(name) && of[name].is_number() && of[name].get<double>() > 0, file, place + "/" + name, "must be a number above 0");
}

void check_kernel(const json &kernel, const std::string &file, const std::string &place) {
    expect(kernel.is_object() && kernel.contains("name") && kernel["name"].is_string(), file, place, "must be an object with a \"name\"");
    for (const char *name : numbers_of_kernels) check_number(kernel, name, file, place);
}

/// How much slower the slowest run was than the fastest.
double spread(const json &kernel) { return kernel["milliseconds_high"].get<double>() / kernel["milliseconds_low"].get<double>() - 1; }

json change(const json &now, const json &before) {
    const double ns_now = now["ns_per_item_and_core"], ns_before = before["ns_per_item_and_core"];
    return {{"name", now["name"]},      {"before", ns_before}, {"now", ns_now}, {"ratio", ns_now / ns_before}, {"spread_before", spread(before)},
            {"spread_now", spread(now)}};
}

/// The kernel of that name, or null.
const json *find_kernel(const json &bench, const json &name) {
    for (const json &kernel : bench["kernels"])
        if (kernel["name"] == name) return &kernel;
    return nullptr;
}

json only_in(const json &bench, const json &other) {
    json names = json::array();
    for (const json &kernel : bench["kernels"])
        if (!find_kernel(other, kernel["name"])) names.push_back(kernel["name"]);
    return names;
}

json difference(const char *what, const json &before, const json &now) { return {{"what", what}, {"before", before}, {"now", now}}; }

json differences(const json &bench, const json &earlier) {
    json all = json::array();
    for (const char *what : circumstances)
        if (bench[what] != earlier[what]) all.push_back(difference(what, earlier[what], bench[what]));
    if (bench["scene_hash"] != earlier["scene_hash"]) all.push_back(difference("scene_hash", earlier["scene_hash"], bench["scene_hash"]));
    if (bench["rays"]["total"] != earlier["rays"]["total"]) all.push_back(difference("rays", earlier["rays"]["total"], bench["rays"]["total"]));
    return all;
}

std::string file_name(const json &path) { return path.get<std::string>().substr(path.get<std::string>().find_last_of('/') + 1); }

std::string names(const char *title, const json &list) {
    if (list.empty()) return "";
    return fmt::format("{}: {}\n", title, fmt::join(list.get<std::vector<std::string>>(), " "));
}

}  // namespace

json read_earlier_bench(const std::string &file) {
    const json earlier = read_json(file);
    if (!earlier.is_object()) throw SceneError(file + ": is not what bench --json gives");
    for (const char *text : {"scene", "scene_hash", "program"})
        expect(earlier.contains(text) && earlier[text].is_string(), file, std::string("/") + text, "must be text");
    for (const char *what : circumstances) expect(earlier.contains(what), file, std::string("/") + what, "is missing");
    expect(earlier.contains("settings") && earlier["settings"].is_object(), file, "/settings", "must be an object");
    expect(earlier.contains("rays") && earlier["rays"].is_object(), file, "/rays", "must be an object");
    check_number(earlier["rays"], "total", file, "/rays");
    check_number(earlier, "seconds", file, "");
    expect(earlier.contains("kernels") && earlier["kernels"].is_array(), file, "/kernels", "must be a list");
    for (std::size_t i = 0; i < earlier["kernels"].size(); ++i) check_kernel(earlier["kernels"][i], file, fmt::format("/kernels/{}", i));
    return earlier;
}

/// Another program may lay out a scene's records in another way: then its file's name has to do.
void check_same_work(const json &subject, const json &earlier, const std::string &file) {
    std::string differing;
    const auto differs = [&](const std::string &what, const std::string &before, const std::string &now) {
        differing += fmt::format("{}{} was {} and is {}", differing.empty() ? "" : ", ", what, before, now);
    };
    const bool same_program = subject["program"] == earlier["program"];
    if (subject["scene_hash"] != earlier["scene_hash"] && (same_program || file_name(subject["scene"]) != file_name(earlier["scene"])))
        differs("scene", fmt::format("'{}' ({})", text_of(earlier["scene"]), text_of(earlier["scene_hash"])),
                fmt::format("'{}' ({})", text_of(subject["scene"]), text_of(subject["scene_hash"])));
    for (const auto &[name, value] : subject["settings"].items()) {
        const json before = earlier["settings"].value(name, json());
        if (before != value) differs(name, text_of(before), text_of(value));
    }
    if (!differing.empty()) throw SceneError(fmt::format("{}: is of other work, which cannot be compared: {}", file, differing));
}

json comparison_json(const json &bench, const json &earlier) {
    json all = {{"seconds_before", earlier["seconds"]},       {"ratio", bench["seconds"].get<double>() / earlier["seconds"].get<double>()},
                {"differences", differences(bench, earlier)}, {"only_before", only_in(earlier, bench)},
                {"only_now", only_in(bench, earlier)},        {"kernels", json::array()}};
    for (const json &kernel : bench["kernels"])
        if (const json *before = find_kernel(earlier, kernel["name"])) all["kernels"].push_back(change(kernel, *before));
    return all;
}

std::string comparison_text(const json &bench) {
    const json &comparison = bench["comparison"];
    std::string text;
    for (const json &each : comparison["differences"])
        text += fmt::format("{} differs: before {}, now {}\n", text_of(each["what"]), text_of(each["before"]), text_of(each["now"]));
    text += "kernel                      ns·core before         now   ratio   spread of both\n";
    for (const json &kernel : comparison["kernels"])
        text += fmt::format("{:<28}{:>14.2f}{:>12.2f}{:>8.3f}{:>9.0f} %{:>5.0f} %\n", text_of(kernel["name"]), kernel["before"].get<double>(),
                            kernel["now"].get<double>(), kernel["ratio"].get<double>(), 100 * kernel["spread_before"].get<double>(),
                            100 * kernel["spread_now"].get<double>());
    text += fmt::format("{:<28}{:>12.3f} s{:>10.3f} s{:>8.3f}\n", "render", comparison["seconds_before"].get<double>(),
                        bench["seconds"].get<double>(), comparison["ratio"].get<double>());
    return text + names("only before", comparison["only_before"]) + names("only now", comparison["only_now"]);
}

}  // namespace brandung
