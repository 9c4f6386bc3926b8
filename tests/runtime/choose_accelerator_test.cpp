/// `auto` tries accelerators on the scene's own rays, and says how each would do.
#include "runtime/accelerators/choose_accelerator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/support/probe.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

Scene small_scene() {
    Scene scene = empty_scene();
    add_soup(scene, 0, {.counts = {{"sphere", 200}}, .size = 0.2f});
    scene.cameras.push_back({.name = "camera", .from = {0, 0, 4}, .at = {0, 0, 0}});
    scene.film.width = scene.film.height = 64;
    return scene;
}

TEST(ChooseAccelerator, TriesAllAndPutsTheFastestFirst) {
    const Scene scene = small_scene();
    std::set<std::string> told;
    const AcceleratorChoice choice =
        choose_accelerator(test_device(), scene, scene.cameras.front(), 4096, {[&](const AcceleratorKind &kind) { told.insert(kind.name); }, {}});
    EXPECT_EQ(choice.trials.size(), accelerator_kinds().size());
    EXPECT_EQ(told.size(), accelerator_kinds().size());
    std::set<std::string> tried;
    for (std::size_t i = 0; i < choice.trials.size(); ++i) {
        const TriedAccelerator &trial = choice.trials[i];
        tried.insert(trial.kind->name);
        EXPECT_GT(trial.trace_seconds, 0) << trial.kind->name;
        EXPECT_TRUE(std::isfinite(trial.trace_seconds)) << trial.kind->name;
        EXPECT_GE(trial.expected_seconds(), choice.trials[i > 0 ? i - 1 : 0].expected_seconds());
    }
    EXPECT_EQ(tried, told);
    EXPECT_GE(choice.rays, 64u * 64u);
    EXPECT_LE(choice.rays_tried, choice.rays);
    for (const std::string &name : tried) EXPECT_NE(text_of(choice).find(name), std::string::npos) << name;
}

/// Every pixel's first sample is traced, so what 16 samples take is 16 times as much.
TEST(ChooseAccelerator, ExpectsMoreRaysOfMoreSamples) {
    Scene scene = small_scene();
    const std::uint64_t once = choose_accelerator(test_device(), scene, scene.cameras.front(), 4096).rays;
    scene.film.spp = 16;
    EXPECT_NEAR(double(choose_accelerator(test_device(), scene, scene.cameras.front(), 4096).rays), 16.0 * double(once), 1.6 * double(once));
}

TEST(ChooseAccelerator, DoesNotTryNoneOnMoreThanAFewPrimitives) {
    Scene scene = small_scene();
    add_soup(scene, 0, {.counts = {{"sphere", 200}}, .size = 0.2f});
    for (const TriedAccelerator &trial : choose_accelerator(test_device(), scene, scene.cameras.front(), 4096).trials)
        EXPECT_STRNE(trial.kind->name, "none");
}

}  // namespace
}  // namespace brandung
