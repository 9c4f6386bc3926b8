/// brandung bench traversal.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/tools/runs.h"
#include "tests/tools/scenes.h"

namespace {

using nlohmann::json;

constexpr std::array ray_names = {"camera", "diffuse", "diffuse2", "shadow", "any"};

Finished run_small(std::vector<std::string> more) {
    std::vector<std::string> arguments = {"bench", "traversal", "--size", "64", "--runs", "2", "--quiet", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
}

bool lacks_embree(const Finished &run) { return run.err.find("built without Embree") != std::string::npos; }

/// The rows of one set of rays.
std::vector<json> rows_of(const json &all, const std::string &rays) {
    std::vector<json> rows;
    std::ranges::copy_if(all.at("rows"), std::back_inserter(rows), [&](const json &row) { return row.at("rays") == rays; });
    return rows;
}

/// One row is the same as another but for the name of the variant.
bool is_repeated(const json &row, const std::vector<json> &rows) {
    return std::ranges::any_of(rows, [&](json other) { return other.at("variant") != "render" && (other["variant"] = "render", other == row); });
}

/// Of those that were measured in both rounds, for the same rays.
double fastest_peer(const json &all, const json &row, const std::string &scene) {
    double best = 0;
    for (const json &peer : all.at("embree_rows")) {
        if (peer.at("scene") != row.at("scene") || peer.at("rays") != row.at("rays") || peer.at("embree_scene") != scene) continue;
        if (peer.at("rounds") == 2) best = std::max(best, peer.at("mrays_per_s").get<double>());
    }
    return best;
}

}  // namespace

TEST(CliBenchTraversal, GivesARowForEachVariantAndTheOneOfARender) {
    const Finished run = run_small({"--procedural", "terrain:5000"});
    expect_success(run);
    const json all = json::parse(run.out);
    EXPECT_EQ(all.at("scenes").at(0).at("scene"), "terrain:5000");
    EXPECT_GT(all.at("scenes").at(0).at("bytes_per_triangle"), 36) << "three vertices";
    for (const char *rays : ray_names) {
        const std::vector<json> rows = rows_of(all, rays);
        ASSERT_GE(rows.size(), 2u) << rays;
        for (const json &row : rows) {
            EXPECT_EQ(row.at("different"), 0);
            EXPECT_GT(row.at("mrays_per_s"), 0);
            EXPECT_EQ(row.at("count"), rows[0].at("count"));
            EXPECT_EQ(row.at("kernel_hash").get<std::string>().size(), 16u);
            EXPECT_TRUE(row.at("ratio").is_null()) << "without a peer";
            EXPECT_TRUE(row.at("mismatches").is_null());
        }
        const auto of_render = std::ranges::find(rows, "render", [](const json &row) { return row.at("variant"); });
        ASSERT_NE(of_render, rows.end()) << rays;
        EXPECT_TRUE(is_repeated(*of_render, rows)) << *of_render;
    }
    EXPECT_EQ(rows_of(all, "camera")[0].at("count"), 64 * 64);
    EXPECT_EQ(rows_of(all, "any")[0].at("count"), rows_of(all, "diffuse")[0].at("count"));
    EXPECT_LT(rows_of(all, "diffuse2")[0].at("count"), rows_of(all, "diffuse")[0].at("count")) << "some go to the sky";
}

TEST(CliBenchTraversal, AgreesWithEmbreeButForRounding) {
    const TemporaryFolder folder;
    const Finished run = run_small({"--procedural", "terrain:5000", folder.write("one.json", native_scene()),
                                    BRANDUNG_SOURCE_DIR "/scene/examples/mesh.json", "--rays", "camera,diffuse,any", "--peer", "embree"});
    if (lacks_embree(run)) GTEST_SKIP() << run.err;
    expect_success(run);
    const json all = json::parse(run.out);
    EXPECT_EQ(all.at("embree").at("version").get<std::string>().front(), '3');
    EXPECT_EQ(all.at("scenes").size(), 3u);
    for (const json &row : all.at("rows")) {
        EXPECT_EQ(row.at("ours_wrong"), 0) << row;
        EXPECT_LE(row.at("mismatches"), 4) << row;
        EXPECT_LE(row.at("ambiguous"), 4) << row;
        EXPECT_GE(row.at("judged").get<double>(), row.at("count").get<double>() / 16) << "whatever both say";
        const double speed = row.at("mrays_per_s");
        for (const char *end : {"", "_high", "_robust"}) {
            const double best = row.at(std::string("embree_best") + end);
            EXPECT_NEAR(row.at(std::string("ratio") + end).get<double>(), speed / best, 1e-9);
            EXPECT_EQ(best, fastest_peer(all, row, *end ? end + 1 : "medium"));
        }
    }
}

/// It has frusta.
TEST(CliBenchTraversal, LeavesEmbreeOutWhereItLacksPrimitives) {
    const Finished run = run_small({BRANDUNG_SOURCE_DIR "/scene/examples/primitives.json", "--rays", "camera", "--peer", "embree"});
    if (lacks_embree(run)) GTEST_SKIP() << run.err;
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.err.find("only triangles and spheres"), std::string::npos) << run.err;
    EXPECT_TRUE(json::parse(run.out).at("rows").at(0).at("ratio").is_null());
}

TEST(CliBenchTraversal, PrintsATable) {
    const TemporaryFolder folder;
    const Finished run =
        run_program({"bench", "traversal", folder.write("one.json", native_scene()), "--rays", "shadow", "--size", "16", "--runs", "1"});
    expect_success(run);
    for (const char *text : {"one   shadow   single", "one   shadow   render", "wide_bvh built in", "Embree medium"})
        EXPECT_NE(run.out.find(text), std::string::npos) << run.out;
}

TEST(CliBenchTraversal, SaysWhatItWasToldWrongly) {
    const auto fault = [](const std::vector<std::string> &arguments) {
        const Finished run = run_small(arguments);
        EXPECT_NE(run.status, 0);
        EXPECT_EQ(lines_of(run.err).size(), 1u) << run.err;
        return run.err;
    };
    EXPECT_NE(fault({}).find("--procedural"), std::string::npos);
    EXPECT_NE(fault({"--procedural", "sea:5000"}).find("must be terrain:N"), std::string::npos);
    EXPECT_NE(fault({"--procedural", "terrain:12"}).find("from 5000 to"), std::string::npos);
    EXPECT_NE(fault({"--procedural", "terrain:5000", "--rays", "camera,mirror"}).find("mirror"), std::string::npos);
    EXPECT_NE(fault({"--procedural", "terrain:5000", "--peer", "optix"}).find("optix"), std::string::npos);
    EXPECT_NE(fault({"--procedural", "terrain:5000", "--accelerator", "bvh9"}).find("bvh9"), std::string::npos);
    EXPECT_NE(fault({"--procedural", "terrain:5000", "--camera", "left"}).find("left"), std::string::npos);
}
