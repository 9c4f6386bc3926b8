/// brandung bench.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/tools/runs.h"
#include "tests/tools/scenes.h"

namespace {

using nlohmann::json;

Finished bench(const TemporaryFolder &folder, const std::vector<std::string> &more) {
    std::vector<std::string> arguments = {"bench", folder.write("scene.json", native_scene()), "--size", "64x64", "--spp", "2", "--quiet", "--runs",
                                          "3"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
}

}  // namespace

TEST(CliBench, MeasuresEveryKernelOfARender) {
    const TemporaryFolder folder;
    const Finished run = bench(folder, {"--json", "--batch", "4096"});
    expect_success(run);
    const json result = json::parse(run.out);
    EXPECT_EQ(result.at("runs"), 3);
    EXPECT_EQ(result.at("rays").at("camera"), 64 * 64 * 2) << "of one render";
    for (const char *limit : {"copy_bytes_per_second", "flops_per_second", "launch_seconds"}) EXPECT_GT(result.at("limits").at(limit), 0) << limit;
    bool generated = false;
    for (const json &kernel : result.at("kernels")) {
        const double items = kernel.at("items"), seconds = kernel.at("milliseconds").get<double>() * 1e-3;
        EXPECT_NEAR(kernel.at("items_per_second").get<double>() * seconds / items, 1, 1e-9) << kernel;
        EXPECT_NEAR(kernel.at("ns_per_item_and_core").get<double>() * items / (1e9 * seconds * result.at("compute_units").get<double>()), 1, 1e-9);
        EXPECT_LE(kernel.at("milliseconds_low"), kernel.at("milliseconds"));
        EXPECT_GE(kernel.at("milliseconds_high"), kernel.at("milliseconds"));
        EXPECT_LE(kernel.at("share_of_launching"), 1);
        if (kernel.at("name") != "generate_camera_rays") continue;
        generated = true;
        EXPECT_EQ(kernel.at("launches"), 2);
        EXPECT_EQ(kernel.at("wave_occupancy"), 1) << "batches are full";
        // A pixel's number, which may be one of several samples', a ray, a path, its place in the list, a sample.
        EXPECT_GE(kernel.at("bytes_per_item"), 32 + 24 + 4 + 48);
        EXPECT_LE(kernel.at("bytes_per_item"), 32 + 24 + 4 + 48 + 8);
    }
    EXPECT_TRUE(generated);
}

TEST(CliBench, ComparesWithAnEarlierOne) {
    const TemporaryFolder folder;
    const Finished first = bench(folder, {"--json"});
    expect_success(first);
    json old = json::parse(first.out);
    for (json &kernel : old.at("kernels")) kernel["ns_per_item_and_core"] = 1e9;
    const Finished second = bench(folder, {"--compare", folder.write("old.json", old.dump())});
    expect_success(second);
    EXPECT_NE(second.out.find("1000000000.00"), std::string::npos) << second.out;
    EXPECT_NE(second.out.find(" 0.000 "), std::string::npos) << "a ratio of next to nothing";
    for (const auto &[file, text] : {std::pair{"none.json", ""}, {"list.json", "[]"}, {"broken.json", "{"}}) {
        if (*text) folder.write(file, text);
        const Finished wrong = bench(folder, {"--compare", folder.path(file)});
        EXPECT_EQ(wrong.status, 1) << file;
        EXPECT_FALSE(wrong.err.empty());
    }
}
