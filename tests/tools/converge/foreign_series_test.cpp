/// tools/converge/foreign_series.
#include "tools/converge/foreign_series.h"

#include <gtest/gtest.h>

#include "scene/error.h"
#include "tests/tools/program.h"

namespace brandung {
namespace {

std::string fault_of(const TemporaryFolder &folder, const std::string &times) {
    folder.write("times.json", times);
    try {
        read_foreign_series("other", folder.path(""), 1, 1);
    } catch (const SceneError &error) {
        return error.what();
    }
    return "no fault";
}

TEST(ForeignSeries, EveryNumberIsCheckedAndNamed) {
    const TemporaryFolder folder;
    write_picture(folder.path("a.exr"), {1, 1, {vec3(1)}, {}});
    const std::string file = folder.path("") + "times.json: ";
    EXPECT_EQ(fault_of(folder, R"([{"file": "a.exr", "seconds": 1, "samples": 4, "rung": 0, "seed": 4294967295}])"), "no fault");
    EXPECT_EQ(fault_of(folder, "{}"), file + "must be a list of {\"file\": ..., \"seconds\": ...}");
    EXPECT_EQ(fault_of(folder, "[7]"), file + "/0: must be an object with a \"file\" and \"seconds\"");
    EXPECT_EQ(fault_of(folder, R"([{"file": 5}])"), file + "/0/file: must be the name of a picture, got 5");
    const auto expect_fault = [&](const std::string &values, const std::string &fault) {
        const std::string good = R"({"file": "a.exr", "seconds": 1}, )";
        EXPECT_EQ(fault_of(folder, "[" + good + R"({"file": "a.exr")" + values + "}]"), file + "/1/" + fault);
    };
    expect_fault("", "seconds: must be a finite number above 0, got nothing");
    expect_fault(R"(, "seconds": -1)", "seconds: must be a finite number above 0, got -1");
    expect_fault(R"(, "seconds": 1, "samples": "many")", "samples: must be a finite number above 0, got \"many\"");
    expect_fault(R"(, "seconds": 1, "seed": 1e20)", "seed: must be a whole number from 0 to 4294967295, got 1e+20");
    expect_fault(R"(, "seconds": 1, "seed": 4294967296)", "seed: must be a whole number from 0 to 4294967295, got 4294967296");
    expect_fault(R"(, "seconds": 1, "seed": -3)", "seed: must be a whole number from 0 to 4294967295, got -3");
    expect_fault(R"(, "seconds": 1, "rung": -3)", "rung: must be a finite number of at least 0, got -3");
}

/// By samples, or by seconds where these are not told; what has the same number is one rung.
TEST(ForeignSeries, RungsAreInOrder) {
    const TemporaryFolder folder;
    write_picture(folder.path("a.exr"), {1, 1, {vec3(1)}, {}});
    folder.write("times.json", R"([{"file": "a.exr", "seconds": 9}, {"file": "a.exr", "seconds": 8, "samples": 4},
        {"file": "a.exr", "seconds": 7, "samples": 2}, {"file": "a.exr", "seconds": 6, "samples": 4}])");
    const ForeignSeries foreign = read_foreign_series("other", folder.path(""), 1, 1);
    std::vector<std::size_t> rungs;
    for (const auto &run : foreign.series.runs) rungs.push_back(run.rung);
    EXPECT_EQ(rungs, (std::vector<std::size_t>{2, 1, 0, 1}));
}

}  // namespace
}  // namespace brandung
