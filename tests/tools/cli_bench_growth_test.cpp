/// brandung bench growth.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/tools/runs.h"

namespace {

using nlohmann::json;

}  // namespace

/// none tests all, in blocks of 8: 100 in 13, 1000 in 125.
TEST(CliBenchGrowth, GivesARowForEachNumberOfObjectsAndAccelerator) {
    const TemporaryFolder folder;
    const Finished run = run_program({"bench", "growth", "--objects", "1000,100", "--only", "uniform_grid,none", "--rays", "512", "--runs", "1",
                                      "--quiet", "--json", "--html", folder.path("growth.html")});
    expect_success(run);
    EXPECT_NE(read_file(folder.path("growth.html")).find("\"accelerator\":\"uniform_grid\""), std::string::npos);
    const json result = json::parse(run.out), &rows = result.at("rows");
    ASSERT_EQ(rows.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(rows[i].at("objects"), i < 2 ? 100 : 1000);
        EXPECT_EQ(rows[i].at("accelerator"), i % 2 ? "none" : "uniform_grid");
        EXPECT_EQ(rows[i].at("rays"), 512);
        EXPECT_EQ(rows[i].at("hits"), rows[i ^ 1].at("hits"));
        EXPECT_GT(rows[i].at("closest_nanoseconds"), 0);
        EXPECT_GT(rows[i].at("any_nanoseconds"), 0);
    }
    EXPECT_EQ(rows[1].at("tests"), 100);
    EXPECT_EQ(rows[1].at("tests_made"), 8 * 13);
    EXPECT_EQ(rows[3].at("tests_made"), 8 * 125);
    EXPECT_GT(rows[0].at("N_TS"), 1);
    EXPECT_LT(rows[2].at("tests"), 200) << "a grid passes over most";
    EXPECT_NEAR(result.at("exponents").at(1).at("tests").get<double>(), 1, 1e-9) << "of none";
}

TEST(CliBenchGrowth, SaysWhatItWasToldWrongly) {
    EXPECT_EQ(run_program({"bench", "growth", "--objects", "0"}).status, 2);
    EXPECT_EQ(run_program({"bench", "growth", "--scene", "cubes"}).status, 2);
    EXPECT_EQ(run_program({"bench", "growth", "--only", "kd"}).status, 1);
}
