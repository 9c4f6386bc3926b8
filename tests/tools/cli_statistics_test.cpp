/// The numbers of --stats.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/tools/program.h"
#include "tests/tools/scenes.h"

namespace {

using nlohmann::json;

json statistics_of(const std::vector<std::string> &more, const std::string &scene = native_scene()) {
    const TemporaryFolder folder;
    std::vector<std::string> arguments = {
        "render", "--quiet", folder.write("scene.json", scene), "-o", folder.path("out.exr"), "--stats", folder.path("stats.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Finished run = run_program(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    return json::parse(read_file(folder.path("stats.json")));
}

}  // namespace

/// The names that --stats promises.
TEST(Statistics, HaveEveryPromisedField) {
    const json stats = statistics_of({"--spp", "2"});
    for (const char *name : {"triangles", "primitives", "lights", "materials"}) EXPECT_TRUE(stats.at("scene").at(name).is_number_unsigned()) << name;
    for (const char *name : {"device", "integrator", "accelerator"}) EXPECT_TRUE(stats.at(name).is_string()) << name;
    for (const char *name : {"width", "height", "spp", "seed"}) EXPECT_TRUE(stats.at(name).is_number_unsigned()) << name;
    for (const char *name : {"read", "scene", "accelerator", "device", "kernels", "render", "write", "total"})
        EXPECT_GE(stats.at("seconds").at(name).get<double>(), 0) << name;
    for (const char *name : {"camera", "reflected", "refracted", "shadow", "total", "camera_hits", "reflected_hits", "refracted_hits", "shadow_hits"})
        EXPECT_TRUE(stats.at("rays").at(name).is_number_unsigned()) << name;
    ASSERT_FALSE(stats.at("kernels").empty());
    for (const json &kernel : stats.at("kernels")) {
        EXPECT_TRUE(kernel.at("name").is_string());
        EXPECT_GT(kernel.at("launches").get<std::uint64_t>(), 0u) << kernel;
        EXPECT_GT(kernel.at("items").get<std::uint64_t>(), 0u) << kernel;
        EXPECT_GE(kernel.at("milliseconds").get<double>(), 0) << kernel;
    }
    for (const char *name : {"scene_bytes", "wave_bytes", "film_bytes"}) EXPECT_GT(stats.at("memory").at(name).get<std::uint64_t>(), 0u) << name;
    EXPECT_TRUE(stats.at("features").at("used").is_array());
    for (const json &hidden : stats.at("features").at("not_shown")) EXPECT_FALSE(hidden.at("why").get<std::string>().empty()) << hidden;
    EXPECT_EQ(stats.at("scene").at("lights"), 1);
    EXPECT_EQ(stats.at("scene").at("light_kinds"), json({{"point", 1}}));
    for (const json &skipped : stats.at("features").at("skipped")) EXPECT_FALSE(skipped.at("why").get<std::string>().empty()) << skipped;
}

TEST(Statistics, SecondsOfThePhasesAddUpToNoMoreThanTheTotal) {
    const json seconds = statistics_of({}).at("seconds");
    double sum = 0;
    for (const auto &[name, value] : seconds.items())
        if (name != "total") sum += value.get<double>();
    EXPECT_LE(sum, seconds.at("total").get<double>() * 1.001);
    EXPECT_GE(sum, seconds.at("total").get<double>() * 0.9) << "little time goes uncounted";
}

/// A closed sphere of radius 1 seen from 4 away under 90 degrees, without mirrors: every number follows.
TEST(Statistics, OfASphereFollowFromItsGeometry) {
    const json stats = statistics_of({"--size", "200x200", "--set", "camera.fov=90", "--spp", "1"});
    const json rays = stats.at("rays");
    EXPECT_EQ(rays.at("camera"), 200 * 200);
    // The outline's half angle is asin 1/4, a circle of radius tan asin 1/4 = 1/sqrt 15 in a square of half width 1; its area in pixels is
    // pi/15 100². A pixel counts if its centre is inside; the error is of the order of the outline's length to the power 2/3, about 30.
    EXPECT_NEAR(rays.at("camera_hits").get<double>(), M_PI / 15 * 1e4, 30);
    EXPECT_EQ(rays.at("reflected"), 0);
    EXPECT_EQ(rays.at("refracted"), 0);
    EXPECT_EQ(rays.at("shadow_hits"), 0) << "a sphere does not shadow its lit side";
    EXPECT_GT(rays.at("shadow"), 0);
    EXPECT_LT(rays.at("shadow"), rays.at("camera_hits"));
    EXPECT_EQ(rays.at("total").get<int>(), rays.at("camera").get<int>() + rays.at("shadow").get<int>());
    EXPECT_EQ(stats.at("refused"), 0);
    EXPECT_EQ(stats.at("clamped"), 0);
}

TEST(Statistics, NameWhatASceneSkips) {
    const json features = statistics_of({}).at("features");
    const auto skips = [&](const std::string &name) {
        for (const json &skipped : features.at("skipped"))
            if (skipped.at("name") == name) return true;
        return false;
    };
    for (const char *name :
         {"primitive triangle", "primitive smooth_triangle", "primitive frustum", "light directional", "spawn_whitted", "find_interfaces"})
        EXPECT_TRUE(skips(name)) << name;
    EXPECT_FALSE(skips("primitive sphere"));
    EXPECT_FALSE(skips("trace_shadow_rays"));
}

TEST(Statistics, MemoryOfTheWavesDoesNotGrowWithThePicture) {
    const json small = statistics_of({"--size", "16x16", "--spp", "16"}).at("memory"),
               big = statistics_of({"--size", "300x200", "--spp", "64"}).at("memory");
    EXPECT_EQ(small.at("wave_bytes"), big.at("wave_bytes"));
    EXPECT_EQ(small.at("scene_bytes"), big.at("scene_bytes"));
    EXPECT_LT(small.at("film_bytes"), big.at("film_bytes"));
    EXPECT_LT(small.at("wave_bytes"), statistics_of({"--batch", "131072"}).at("memory").at("wave_bytes")) << "the batch decides";
}
