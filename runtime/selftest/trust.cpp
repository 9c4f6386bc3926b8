#include "runtime/selftest/trust.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "brandung_version.h"
#include "runtime/opencl/source.h"
#include "scene/output.h"

namespace brandung {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json key_of(const DeviceInfo &device) {
    return {{"platform", device.platform},
            {"device", device.name},
            {"driver", device.driver},
            {"program", BRANDUNG_VERSION " (" BRANDUNG_GIT ")"},
            {"kernels", fmt::format("{:016x}", hash_of_kernels())}};
}

/// All verdicts: [{"key": {...}, "subjects": {name: {"passed", "kernels", "fault", "rounds", "date"}}}]. Rounds are those of inputs that were tried,
/// up to the one that failed.
struct Verdicts {
    json list = json::array();
    std::string warning;
};

/// What an entry must have for the rest to rely on it. Those of older programs, which hold for these only, have neither rounds nor dates.
void check_form(json &list) {
    for (json &verdict : list) {
        verdict.at("key").get<json::object_t>(), verdict.at("subjects").get<json::object_t>();
        for (json &subject : verdict["subjects"]) {
            subject.emplace("rounds", 0), subject.emplace("date", "");
            subject.at("passed").get<bool>(), subject.at("kernels").get<std::string>();
            subject.at("rounds").get<uint>(), subject.at("date").get<std::string>();
        }
    }
}

Verdicts read_verdicts(const std::string &file) {
    std::ifstream in(file);
    if (!in) return {};
    try {
        Verdicts verdicts{json::parse(in), {}};
        check_form(verdicts.list);
        return verdicts;
    } catch (const json::exception &error) {
        return {json::array(), fmt::format("{}: not understood, so what it says of self-tests is forgotten ({})", file, error.what())};
    }
}

/// So many verdicts are kept; the oldest go first.
constexpr std::size_t most_verdicts = 64;

/// Null if there is none.
json *entry_of(json &list, const json &key) {
    for (json &verdict : list)
        if (verdict["key"] == key) return &verdict;
    return nullptr;
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    char text[] = "YYYY-MM-DD";
    std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
    return text;
}

/// Every subject of the list passed, on all inputs of a default run.
bool is_whole(const json &verdicts) {
    return std::all_of(subjects().begin(), subjects().end(), [&](const SubjectEntry &subject) {
        return verdicts.contains(subject.name) && verdicts[subject.name]["rounds"] >= subject.rounds;
    });
}

/// Replaces what is known of a subject, unless that rests on more inputs. The failure that was found last is known by the inputs of the longest run
/// to one, so that a pass which takes it back has tried those of every failure.
void remember(const SubjectReport &report, json &subjects) {
    uint rounds = report.rounds;
    if (const auto known = subjects.find(report.subject->name); known != subjects.end()) {
        if (report.passed() && rounds < (*known)["rounds"]) return;
        if (!report.passed() && !(*known)["passed"]) rounds = std::max(rounds, (*known)["rounds"].get<uint>());
    }
    subjects[report.subject->name] = {
        {"passed", report.passed()}, {"kernels", report.subject->file}, {"fault", report.fault}, {"rounds", rounds}, {"date", today()}};
}

}  // namespace

std::string verdicts_file() {
    const char *cache = std::getenv("XDG_CACHE_HOME"), *home = std::getenv("HOME");
    if (cache && fs::path(cache).is_absolute()) return fs::path(cache) / "brandung" / "selftest.json";
    return home && *home ? fs::path(home) / ".cache" / "brandung" / "selftest.json" : fs::path();
}

Trust known_trust(const DeviceInfo &device) {
    Verdicts verdicts = read_verdicts(verdicts_file());
    Trust trust{.warning = verdicts.warning};
    const json *const entry = entry_of(verdicts.list, key_of(device));
    if (!entry || entry->at("subjects").empty()) return trust;
    std::string passed_since, failed_since;
    for (const auto &[name, subject] : entry->at("subjects").items()) {
        const auto date = subject["date"].get<std::string>();
        std::string &oldest = subject["passed"] ? passed_since : failed_since;
        if (oldest.empty() || date < oldest) oldest = date;
        if (!subject["passed"])
            trust.why_not += fmt::format("{}{} (kernels {})", trust.why_not.empty() ? "" : ", ", name, subject["kernels"].get<std::string>());
    }
    trust.date = trust.why_not.empty() ? passed_since : failed_since;
    trust.outcome = !trust.why_not.empty() ? Outcome::failed : is_whole(entry->at("subjects")) ? Outcome::passed : Outcome::incomplete;
    return trust;
}

std::string remember(const DeviceInfo &device, const std::vector<SubjectReport> &reports) {
    const std::string file = verdicts_file();
    if (file.empty()) return "neither XDG_CACHE_HOME nor HOME names a folder, so the verdict is not remembered";
    Verdicts verdicts = read_verdicts(file);
    const json key = key_of(device);
    json *entry = entry_of(verdicts.list, key);
    if (!entry) entry = &verdicts.list.emplace_back(json{{"key", key}, {"subjects", json::object()}});
    for (const SubjectReport &report : reports)
        if (report.rounds > 0 || !report.passed()) remember(report, (*entry)["subjects"]);
    while (verdicts.list.size() > most_verdicts) verdicts.list.erase(0);
    try {
        fs::create_directories(fs::path(file).parent_path());
        write_text(file, verdicts.list.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
    } catch (const std::exception &error) {
        return fmt::format("the verdict is not remembered: {}", error.what());
    }
    return verdicts.warning;
}

}  // namespace brandung
