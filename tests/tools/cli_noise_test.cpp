/// brandung render: noise in statistics and metadata, --error and --time.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/tools/runs.h"
#include "tests/tools/scenes.h"

namespace {

using nlohmann::json;

/// Of native_scene(), small.
struct NoisyRun {
    explicit NoisyRun(const std::vector<std::string> &more) {
        std::vector<std::string> arguments = {"render",
                                              "--quiet",
                                              folder.write("scene.json", native_scene()),
                                              "--size",
                                              "64x48",
                                              "-o",
                                              folder.path("out.exr"),
                                              "--stats",
                                              folder.path("stats.json")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expect_success(run_program(arguments));
        stats = json::parse(read_file(folder.path("stats.json")));
    }
    TemporaryFolder folder;
    json stats;
};

}  // namespace

TEST(NoiseOfRenders, IsInStatisticsFromTwoSamplesOn) {
    EXPECT_TRUE(NoisyRun({"--spp", "1"}).stats.at("noise").is_null());
    const NoisyRun run({"--spp", "8", "--set", "integrator.threshold=0.25", "--set", "materials.0.reflection=0.5", "--max-depth", "1"});
    const json error = run.stats.at("noise");
    EXPECT_GT(error.at("relmse"), 0);
    EXPECT_LT(error.at("confidence_95").at(0), error.at("relmse"));
    EXPECT_GT(error.at("confidence_95").at(1), error.at("relmse"));
    std::vector<std::string> names;
    for (const json &bias : run.stats.at("biased_by")) names.push_back(bias.at("name"));
    EXPECT_EQ(names, (std::vector<std::string>{"depth limit", "adaptive depth"}));
    EXPECT_EQ(NoisyRun({"--spp", "2"}).stats.at("biased_by"), json::array());
}

TEST(NoiseOfRenders, ErrorEndsTheRenderThere) {
    const NoisyRun run({"--error", "0.001"});
    const json error = run.stats.at("noise");
    EXPECT_LE(error.at("confidence_95").at(1), 0.001);
    EXPECT_EQ(run.stats.at("samples_done"), run.stats.at("samples_total"));
    EXPECT_EQ(run.stats.at("samples_done"), run.stats.at("spp").get<std::uint64_t>() * 64 * 48);
    EXPECT_FALSE(run.stats.at("interrupted"));
    EXPECT_EQ(run.stats.at("stopped_by"), "error");
}

TEST(NoiseOfRenders, TimeEndsTheRenderInTime) {
    const NoisyRun run({"--time", "1.5", "--seed", "2"});
    EXPECT_LT(run.stats.at("samples_done"), std::uint64_t{64} * 48 << 24);
    EXPECT_GE(run.stats.at("seconds").at("render"), 1.5);
    EXPECT_GT(run.stats.at("spp"), 1);
    EXPECT_EQ(run.stats.at("stopped_by"), "time");
}

/// Where nobody has asked for a number of samples, none is told.
TEST(NoiseOfRenders, ErrorThatIsNotReachedIsTold) {
    const TemporaryFolder folder;
    const Finished run = render_native(folder, {"-o", folder.path("out.exr"), "--error", "1e-9", "--spp", "6"});
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.err.find("warning: the noise is not below 1e-09: 6 spp came first\n"), std::string::npos) << run.err;
    const Finished unknown = render_native(folder, {"-o", folder.path("out.exr"), "--error", "0.1", "--spp", "1"});
    EXPECT_NE(unknown.err.find("warning: whether the noise is below 0.1 is not known: 1 spp came first, and"), std::string::npos) << unknown.err;
    const Finished timed = render_native(folder, {"-o", folder.path("out.exr"), "--error", "1e-9", "--time", "0.01"});
    EXPECT_NE(timed.err.find("warning: the noise is not below 1e-09: 0.01 s came first\n"), std::string::npos) << timed.err;
    EXPECT_EQ(timed.err.find("16777216"), std::string::npos) << timed.err;
    const Finished quiet = render_native(folder, {"-o", folder.path("out.exr"), "--error", "1e-9", "--spp", "6", "--quiet"});
    EXPECT_EQ(quiet.err, "warning: the noise is not below 1e-09: 6 spp came first\n");
}

TEST(NoiseOfRenders, SppIsALimitOfBoth) {
    const NoisyRun run({"--error", "1e-9", "--time", "1000", "--spp", "6"});
    EXPECT_EQ(run.stats.at("spp"), 6);
    EXPECT_EQ(run.stats.at("stopped_by"), "samples");
    EXPECT_GT(run.stats.at("noise").at("relmse"), 1e-9);
}

TEST(NoiseOfRenders, RulesThatCannotBeAreRefused) {
    const TemporaryFolder folder;
    for (const char *rule : {"--error", "--time"})
        for (const char *value : {"0", "-1", "nan", "inf", "much"}) {
            const Finished run = render_native(folder, {"-o", folder.path("out.exr"), rule, value});
            EXPECT_EQ(run.status, 2) << rule << ' ' << value;
            EXPECT_NE(run.err.find(rule), std::string::npos) << run.err;
        }
}
