/// tools/bench/comparison.
#include "tools/bench/comparison.h"

#include <gtest/gtest.h>

#include "scene/error.h"
#include "tests/tools/program.h"

namespace brandung {
namespace {

using nlohmann::json;

/// Two kernels: the first takes 3 ns, in its slowest run 1.5 times as long as in its fastest.
json example() {
    const auto kernel = [](const char *name, double ns) {
        return json{{"name", name}, {"ns_per_item_and_core", ns}, {"milliseconds_low", 2}, {"milliseconds_high", 3}};
    };
    return {{"scene", "a/scene.json"}, {"scene_hash", "0123"},  {"settings", {{"spp", "2"}, {"width", "64"}, {"max_depth", "5"}}},
            {"program", "brandung 1"}, {"device", "cpu"},       {"driver", "2"},
            {"compute_units", 2},      {"accelerator", "none"}, {"batch", 1024},
            {"rays", {{"total", 7}}},  {"seconds", 1.5},        {"kernels", {kernel("intersect", 3), kernel("shade", 4)}}};
}

std::string fault_of(auto action) {
    try {
        action();
    } catch (const SceneError &error) {
        return error.what();
    }
    return "no fault";
}

TEST(BenchComparison, WhatIsNoBenchIsSaidByItsPlace) {
    const TemporaryFolder folder;
    const auto fault = [&](const json &earlier) {
        const std::string file = folder.write("old.json", earlier.dump()), text = fault_of([&] { read_earlier_bench(file); });
        return text.starts_with(file + ": ") ? text.substr(file.size() + 2) : text;
    };
    const std::string question = "; is it of bench --json?";
    json wrong = example();
    EXPECT_EQ(fault(wrong), "no fault");
    wrong["kernels"] = {5};
    EXPECT_EQ(fault(wrong), "/kernels/0: must be an object with a \"name\"" + question);
    wrong = example(), wrong["kernels"][1]["milliseconds_low"] = "fast";
    EXPECT_EQ(fault(wrong), "/kernels/1/milliseconds_low: must be a number above 0" + question);
    wrong = example(), wrong["rays"].erase("total");
    EXPECT_EQ(fault(wrong), "/rays/total: must be a number above 0" + question);
    wrong = example(), wrong.erase("driver");
    EXPECT_EQ(fault(wrong), "/driver: is missing" + question);
    EXPECT_EQ(fault(json::object({{"kernels", {5}}})), "/scene: must be text" + question);
    EXPECT_EQ(fault(json::array()), "is not what bench --json gives");
    EXPECT_EQ(fault_of([&] { read_earlier_bench(folder.path("none.json")); }), folder.path("none.json") + ": no such file");
}

TEST(BenchComparison, OtherWorkIsRefused) {
    const auto fault = [](const json &now) { return fault_of([&] { check_same_work(now, example(), "old.json"); }); };
    const std::string start = "old.json: is of other work, which cannot be compared: ";
    json now = example();
    now["device"] = "gpu", now["batch"] = 1, now["accelerator"] = "wide_bvh", now["scene"] = "b/scene.json";
    EXPECT_EQ(fault(now), "no fault") << "the same work";
    now["settings"]["spp"] = "4", now["settings"]["max_depth"] = "3";
    EXPECT_EQ(fault(now), start + "max_depth was 5 and is 3, spp was 2 and is 4");
    now = example(), now["scene_hash"] = "4567";
    EXPECT_EQ(fault(now), start + "scene was 'a/scene.json' (0123) and is 'a/scene.json' (4567)");
    now["program"] = "brandung 2";
    EXPECT_EQ(fault(now), "no fault") << "whose records another program may lay out in another way";
    now["scene"] = "a/other.json";
    EXPECT_EQ(fault(now), start + "scene was 'a/scene.json' (0123) and is 'a/other.json' (4567)");
}

TEST(BenchComparison, EveryKernelAndDifferenceIsNamed) {
    json now = example();
    now["device"] = "gpu", now["seconds"] = 3, now["kernels"][1]["name"] = "accumulate", now["kernels"][0]["ns_per_item_and_core"] = 6;
    const json comparison = comparison_json(now, example());
    EXPECT_EQ(comparison.at("only_before"), json({"shade"}));
    EXPECT_EQ(comparison.at("only_now"), json({"accumulate"}));
    EXPECT_EQ(comparison.at("differences"), json::array({{{"what", "device"}, {"before", "cpu"}, {"now", "gpu"}}}));
    EXPECT_EQ(comparison.at("ratio"), 2);
    ASSERT_EQ(comparison.at("kernels").size(), 1u);
    EXPECT_EQ(comparison.at("kernels")[0].at("ratio"), 2);
    EXPECT_EQ(comparison.at("kernels")[0].at("spread_before"), 0.5);
    now["comparison"] = comparison;
    const std::string text = comparison_text(now);
    for (const char *line : {"device differs: before cpu, now gpu\n", "\nonly before: shade\n", "\nonly now: accumulate\n"})
        EXPECT_NE(text.find(line), std::string::npos) << line << text;
}

}  // namespace
}  // namespace brandung
