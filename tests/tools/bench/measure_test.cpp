/// tools/bench/measure, and what is reported where it ends early.
#include "tools/bench/measure.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <utility>

#include "tests/tools/program.h"
#include "tests/tools/scenes.h"
#include "tools/bench/report.h"

namespace brandung {
namespace {

/// Told to end when the second run has begun, whose first step is made to take longer than the 0.2 s until the render asks: only the first run
/// counts.
TEST(BenchMeasure, ABrokenRunIsDroppedAndTheOthersAreReported) {
    const TemporaryFolder folder;
    SceneOptions options;
    options.scene = folder.write("scene.json", native_scene());
    options.spp = 64, options.batch = 4096;
    const Scene scene = read_scene(options);
    uint begun = 0;
    bool delayed = false;
    const auto delay = [&](auto &&...) {
        if (begun == 2 && !std::exchange(delayed, true)) std::this_thread::sleep_for(std::chrono::milliseconds(300));
    };
    Job job(scene, options, {.on_build = {}, .on_built = {}, .on_launch = {}, .on_step = delay});
    const auto tell = [&](uint run) { begun = run; };
    const Measurements measurements = measure(job, 5, tell, [&] { return begun < 2; });
    EXPECT_TRUE(delayed);
    ASSERT_EQ(measurements.seconds.size(), 1u);
    EXPECT_TRUE(measurements.interrupted());
    EXPECT_EQ(measurements.rays.rays[RAY_CAMERA], 32u * 24 * 64) << "of a whole run";
    for (const auto &[name, runs] : measurements.kernels) EXPECT_EQ(runs.milliseconds.size(), 1u) << name;
    const nlohmann::json bench = bench_json(job, options.batch, measurements);
    EXPECT_EQ(bench.at("interrupted"), true);
    EXPECT_EQ(bench.at("runs"), 1);
    EXPECT_NE(bench_text(bench).find("\ninterrupted: 1 of 5 runs\n"), std::string::npos);
}

}  // namespace
}  // namespace brandung
