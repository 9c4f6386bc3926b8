/// Random scenes, a few of the many that tools/random_scenes tries, and those that have ever failed.
#include <gtest/gtest.h>

#include "tests/support/random_scenes/trial.h"

namespace brandung {
namespace {

/// With one sampler and one way to follow rays; tools/random_scenes tries the others.
Scene read_alike(std::uint64_t seed, double scale = 1) {
    Scene scene = read_random_scene(seed, scale);
    scene.film.sampler = 0, scene.integrator.follows_one = false;
    return scene;
}

void expect_no_faults(std::uint64_t seed, Scene scene, bool specialised, Scene *scaled = nullptr) {
    for (const std::string &fault : faults_of(scene, specialised, scaled)) ADD_FAILURE() << "seed " << seed << ": " << fault;
}

}  // namespace

/// With one filter and one kind of shadows too, so that all take the same kernels.
TEST(RandomScenes, AreTheSameForEveryAcceleratorBatchAndScale) {
    for (std::uint64_t seed = 100; seed < 200; ++seed) {
        Scene scene = read_alike(seed), scaled = read_alike(seed, 0x1p-10);
        for (Scene *which : {&scene, &scaled}) which->film.filter = 0, which->integrator.filtered_shadows = true;
        const bool scalable = is_scalable(scene);
        expect_no_faults(seed, std::move(scene), false, scalable ? &scaled : nullptr);
    }
}

TEST(RandomScenes, AreTheSameWithKernelsOfTheirOwn) { expect_no_faults(207, read_random_scene(207), true); }

/// 0: a spot light beside instances that shine, whose intensity was read as the number of one. 7996, 9623: rays that begin just beyond the box of a
/// flat cone, which met it by rounding unless an accelerator had looked at the box before.
TEST(RandomScenes, ThatHaveFailedFailNoMore) {
    for (const std::uint64_t seed : {0u, 7996u, 9623u}) expect_no_faults(seed, read_alike(seed), false);
}

}  // namespace brandung
