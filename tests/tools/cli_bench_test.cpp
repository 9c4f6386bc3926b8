/// brandung bench.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/tools/runs.h"
#include "tests/tools/scenes.h"

namespace {

using nlohmann::json;

Finished bench(const TemporaryFolder &folder, const std::vector<std::string> &more) {
    std::vector<std::string> arguments = {"bench", folder.write("scene.json", native_scene()), "--quiet", "--runs", "1"};
    for (const char *setting : {"film.width=64", "film.height=64", "film.spp=2"}) arguments.insert(arguments.end(), {"--set", setting});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
}

}  // namespace

/// Of a scene whose rays branch, in batches that the first of them fill.
TEST(CliBench, MeasuresEveryKernelOfARender) {
    const Finished run = run_program({"bench", BRANDUNG_SOURCE_DIR "/scene/examples/whitted_1980.json", "--size", "64x64", "--spp", "2", "--quiet",
                                      "--runs", "3", "--json", "--batch", "4096"});
    expect_success(run);
    const json result = json::parse(run.out);
    EXPECT_EQ(result.at("runs"), 3);
    EXPECT_EQ(result.at("interrupted"), false);
    EXPECT_EQ(result.at("rays").at("camera"), 64 * 64 * 2) << "of one render";
    for (const char *limit : {"copy_bytes_per_second", "flops_per_second", "launch_seconds"}) EXPECT_GT(result.at("limits").at(limit), 0) << limit;
    for (const char *part : {"running", "launching", "rest"}) EXPECT_GT(result.at("parts_of_seconds").at(part), 0) << part;
    for (const json &kernel : result.at("kernels")) {
        const double items = kernel.at("items"), seconds = kernel.at("milliseconds").get<double>() * 1e-3;
        EXPECT_NEAR(kernel.at("items_per_second").get<double>() * seconds / items, 1, 1e-9) << kernel;
        EXPECT_NEAR(kernel.at("ns_per_item_and_core").get<double>() * items / (1e9 * seconds * result.at("compute_units").get<double>()), 1, 1e-9);
        EXPECT_LE(kernel.at("milliseconds_low"), kernel.at("milliseconds"));
        EXPECT_GE(kernel.at("milliseconds_high"), kernel.at("milliseconds"));
        EXPECT_GT(kernel.at("share_of_launching"), 0);
        EXPECT_LT(kernel.at("share_of_launching"), 1);
        EXPECT_TRUE(kernel.at("wave_occupancy").is_null() || kernel.at("wave_occupancy") <= 1) << kernel;
    }
}

/// 64 x 64 pixels of two samples fill two batches of 4096. A pixel's number is shared by its two samples; a batch has room for 2048 pixels.
TEST(CliBench, CountsBytesAndRoomOfTheQueuesThatAKernelWorksOn) {
    const TemporaryFolder folder;
    const Finished run = bench(folder, {"--json", "--batch", "4096"});
    expect_success(run);
    const json result = json::parse(run.out);
    const auto kernel = [&](const std::string &name) {
        for (const json &each : result.at("kernels"))
            if (each.at("name") == name) return each;
        ADD_FAILURE() << "there is no " << name;
        return json();
    };
    const json generate = kernel("generate_camera_rays"), add = kernel("add_samples"), accumulate = kernel("accumulate");
    EXPECT_EQ(generate.at("launches"), 2);
    EXPECT_EQ(generate.at("bytes_per_item"), 4 / 2 + 32 + 24 + 4 + 48) << "pixel, ray, path, place in the list, sample";
    EXPECT_EQ(accumulate.at("bytes_per_item"), 4 + 24 + 12 + 2 * 48) << "place in the list, path, contribution, a sample read and written";
    EXPECT_EQ(add.at("bytes_per_item"), 4 + 2 * 48 + 2 * 200) << "pixel, two samples, sums and squares read and written";
    for (const json &full : {generate, add, accumulate}) EXPECT_EQ(full.at("wave_occupancy"), 1) << full;
    EXPECT_NEAR(kernel("spawn_shadow_rays").at("wave_occupancy").get<double>(), 1, 0.01) << "of the queue of shadow rays";
    for (const char *searching : {"intersect_packets", "trace_shadow_rays", "evaluate_surfaces"})
        for (const char *what : {"bytes_per_item", "bytes_per_second", "share_of_copy"})
            EXPECT_TRUE(kernel(searching).at(what).is_null()) << searching << ": " << what;
}

/// The same scene in other batches; then other samples, of which nothing is measured.
TEST(CliBench, ComparesWithAnEarlierOne) {
    const TemporaryFolder folder;
    const Finished first = bench(folder, {"--json"});
    expect_success(first);
    json old = json::parse(first.out);
    for (json &kernel : old.at("kernels")) kernel["ns_per_item_and_core"] = 1e9;
    const std::string file = folder.write("old.json", old.dump());
    const Finished second = bench(folder, {"--compare", file, "--batch", "1024"});
    expect_success(second);
    EXPECT_NE(second.out.find("1000000000.00"), std::string::npos) << second.out;
    EXPECT_NE(second.out.find(" 0.000 "), std::string::npos) << "a ratio of next to nothing";
    EXPECT_NE(second.out.find("\nbatch differs: before 65536, now 1024\n"), std::string::npos) << second.out;
    const Finished other = bench(folder, {"--compare", file, "--spp", "4"});
    EXPECT_EQ(other.status, 1);
    EXPECT_EQ(other.err, "brandung: " + file + ": is of other work, which cannot be compared: spp was 2 and is 4\n");
    const Finished moved = bench(folder, {"--compare", file, "--set", "objects.0.radius=2"});
    EXPECT_EQ(moved.status, 1);
    EXPECT_NE(moved.err.find("cannot be compared: scene was '"), std::string::npos) << moved.err;
}
