/// How the error of path tracing falls with samples.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scene/kinds.h"
#include "scene/samplers/sampler.h"
#include "tests/images/irradiance.h"

namespace {

using namespace brandung;
using namespace irradiance;

/// A floor under a square lamp that nothing hides and the eye does not see: the light at every point is smooth in all the numbers that choose it.
/// Paths do not go on.
Scene smooth_scene(const char *sampler, uint spp, uint seed) {
    Scene scene = scene_seen_at({0, 1.5f, 4}, {0, 0, 0});
    scene.cameras[0].fov = 0.35f;
    scene.film.width = 24, scene.film.height = 16;
    scene.film.sampler = kind_number(sampler_kinds(), sampler);
    scene.film.spp = spp, scene.film.seed = seed;
    scene.integrator.type = "path", scene.integrator.max_depth = 1;
    add_floor(scene);
    add_quad(scene, 1, {-1, 2, -1}, {2, 0, 0}, {0, 0, 2});
    return scene;
}

/// The slope of the root of the mean squared error over samples per pixel, 4 to 256, in logarithms, by least squares.
double slope_of(const char *sampler, const std::vector<vec3> &reference) {
    constexpr uint seeds = 4;
    double xx = 0, xy = 0;
    for (int rung = -3; rung <= 3; ++rung) {
        double sum = 0;
        for (uint seed = 1; seed <= seeds; ++seed) {
            const std::vector<vec3> picture = render_scene(smooth_scene(sampler, 32u << (rung + 3) >> 3, seed)).picture;
            for (std::size_t i = 0; i < picture.size(); ++i) sum += std::pow(double(picture[i].x) - double(reference[i].x), 2);
        }
        const double x = rung, y = std::log2(sum) / 2;
        xx += x * x, xy += x * y;
    }
    return xy / xx;
}

}  // namespace

/// The error of a slope is about 0.01 by 384 pixels, 4 seeds and 7 rungs.
TEST(Convergence, IndependentSamplesHaveTheRootsSlopeAndSobolsASteeperOne) {
    const std::vector<vec3> reference = render_scene(smooth_scene("sobol", 1 << 14, 5)).picture;
    const double independent = slope_of("independent", reference), sobol = slope_of("sobol", reference);
    RecordProperty("independent", std::to_string(independent)), RecordProperty("sobol", std::to_string(sobol));
    EXPECT_NEAR(independent, -0.5, 0.03);
    EXPECT_LT(sobol, -0.65);
}
