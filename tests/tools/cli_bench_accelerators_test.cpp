/// brandung bench accelerators.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/tools/runs.h"
#include "tests/tools/scenes.h"

namespace {

using nlohmann::json;

std::vector<std::string> command(const std::string &scene, const std::vector<std::string> &more) {
    std::vector<std::string> arguments = {"bench", "accelerators", scene, "--quiet", "--only", "uniform_grid,none", "--runs", "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

}  // namespace

/// What lists no primitives in cells makes as many tests as it says; a wide BVH has leaves, which are cells.
TEST(CliBenchAccelerators, CountsTheTestsOfStructuresWithoutLists) {
    const TemporaryFolder folder;
    const Finished run = run_program({"bench", "accelerators", folder.write("one.json", native_scene()), "--quiet", "--only", "wide_bvh", "--json"});
    expect_success(run);
    const json camera = json::parse(run.out).at("accelerators").at(0).at("rays").at("camera");
    EXPECT_GT(camera.at("tests"), 0);
    EXPECT_GT(camera.at("N_ETS"), 0);
    EXPECT_EQ(camera.at("N_IT"), camera.at("tests"));
}

/// One sphere in 32 x 24 pixels, nothing of which mirrors.
TEST(CliBenchAccelerators, GivesARowForEachSceneAndAccelerator) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("one.json", native_scene());
    const Finished run = run_program(command(scene, {scene, "--check", "--random", "4000", "--json"}));
    expect_success(run);
    const json result = json::parse(run.out), &rows = result.at("accelerators");
    EXPECT_EQ(result.at("runs"), 2);
    EXPECT_EQ(result.at("interrupted"), false);
    ASSERT_EQ(rows.size(), 4);
    for (std::size_t i = 0; i < 4; ++i) {
        const json &row = rows[i], &camera = row.at("rays").at("camera");
        EXPECT_EQ(row.at("scene"), "one");
        EXPECT_EQ(row.at("accelerator"), i % 2 ? "none" : "uniform_grid");
        EXPECT_EQ(row.at("primitives"), 1);
        EXPECT_EQ(row.at("different"), 0);
        EXPECT_EQ(camera.at("rays"), 32 * 24);
        EXPECT_NEAR(camera.at("seconds").get<double>() * camera.at("rays_per_second").get<double>(), 32 * 24, 1e-6);
        EXPECT_EQ(row.at("rays").at("secondary").at("rays"), 0);
        EXPECT_TRUE(row.at("rays").at("secondary").at("rays_per_second").is_null());
        EXPECT_GT(row.at("rays").at("shadow").at("rays"), 0);
        EXPECT_LT(row.at("rays").at("shadow").at("rays"), camera.at("hits")) << "some of what the eye sees turns away from the light";
        EXPECT_EQ(row.at("rays").at("random").at("rays"), 2 * 4000);
    }
    EXPECT_EQ(rows[1].at("rays").at("camera").at("N_IT"), 1) << "none tests every primitive";
    EXPECT_EQ(rows[1].at("rays").at("camera").at("tests_made"), 8) << "in a block of 8";
}

/// With the kernels that the bench has built.
TEST(CliAuto, SaysWhatItHasTriedAndWhy) {
    const TemporaryFolder folder;
    const Finished run = run_program({"render", folder.write("one.json", native_scene()), "--accelerator", "auto", "-o", folder.path("one.png"),
                                      "--stats", folder.path("one.stats.json"), "--explain"});
    expect_success(run);
    const json statistics = json::parse(read_file(folder.path("one.stats.json"))), &choice = statistics.at("accelerator_choice");
    ASSERT_GE(choice.at("accelerators").size(), 4u);
    EXPECT_EQ(choice.at("accelerators")[0].at("name"), statistics.at("accelerator"));
    EXPECT_GE(choice.at("rays"), statistics.at("rays").at("camera"));
    EXPECT_GT(statistics.at("seconds").at("accelerator_choice"), 0);
    EXPECT_NE(run.out.find("chosen by auto"), std::string::npos) << run.out;
}

TEST(CliBenchAccelerators, PrintsATable) {
    const TemporaryFolder folder;
    const Finished run = run_program(command(folder.write("one.json", native_scene()), {"--rays", "100"}));
    expect_success(run);
    for (const char *text : {"accelerator", "different", "one   uniform_grid", "one   none"})
        EXPECT_NE(run.out.find(text), std::string::npos) << text;
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 4) << "two lines of titles, two rows";
}

TEST(CliBenchAccelerators, SaysWhatItWasToldWrongly) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("one.json", native_scene());
    EXPECT_EQ(run_program({"bench", "accelerators"}).status, 2);
    EXPECT_EQ(run_program({"bench"}).status, 2);
    EXPECT_EQ(run_program({"bench", "accelerators", scene, "--runs", "0"}).status, 2);
    const Finished unknown = run_program({"bench", "accelerators", scene, "--only", "kd"});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_NE(unknown.err.find("\"kd\" is not known"), std::string::npos) << unknown.err;
}

TEST(CliBenchVolumes, MeasuresEveryTest) {
    const Finished run = run_program({"bench", "volumes", "--json"});
    expect_success(run);
    const json costs = json::parse(run.out).at("nanoseconds");
    EXPECT_EQ(costs.size(), 10u) << "five kinds of volumes and of primitives";
    for (const char *name : {"box", "block: sphere", "block: triangle", "block: smooth_triangle", "block: frustum", "block: disk"})
        EXPECT_GT(costs.at(name), 0) << name;
}
