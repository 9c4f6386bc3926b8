/// Renders of what moves while the shutter is open: what analysis and still pictures at single times say of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>

#include "scene/accelerators/accelerator.h"
#include "scene/kinds.h"
#include "scene/samplers/sampler.h"
#include "tests/images/irradiance.h"
#include "tests/images/moving_scenes.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"
#include "tests/support/statistics/significance.h"

namespace {

using namespace brandung;
using namespace brandung::motion;

/// Part of a pixel and of the time that a disk of this radius covers whose middle goes from a to b, by many points of both.
double coverage(uint x, uint y, glm::dvec2 a, glm::dvec2 b, double radius) {
    constexpr int places = 24, times = 96;
    int inside = 0;
    for (int i = 0; i < places * places * times; ++i) {
        const double u = (i % places + 0.5) / places, v = (i / places % places + 0.5) / places, t = (i / (places * places) + 0.5) / times;
        const glm::dvec2 p(-4 + 8 * (x + u) / width, 3 - 6 * (y + v) / height);
        inside += glm::length(p - (a + t * (b - a))) < radius;
    }
    return double(inside) / (places * places * times);
}

class MovingBall : public testing::TestWithParam<const char *> {};

/// A picture against the means that its pixels should have, whose values in between are 0 and 1.
void expect_coverage(const Scene &scene, const std::vector<vec3> &picture, glm::dvec2 a, glm::dvec2 b, double radius) {
    double sum = 0, expected_sum = 0;
    uint partial = 0;
    for (uint y = 0; y < height; ++y)
        for (uint x = 0; x < width; ++x) {
            const double expected = coverage(x, y, a, b, radius), found = luminance(picture[y * width + x]);
            sum += found, expected_sum += expected;
            partial += expected > 0.05 && expected < 0.95;
            const double deviation = std::sqrt(expected * (1 - expected) / scene.film.spp);  // as if samples were anywhere
            EXPECT_NEAR(found, expected, 4 * deviation + 0.003) << x << ", " << y;
        }
    EXPECT_NEAR(sum, expected_sum, 0.01 * expected_sum);
    EXPECT_GT(partial, 30u) << "the ball moves";
}

/// From time 0 to 1 it goes its way; light does not come from it, it is but seen.
Scene shining_ball(const std::string &integrator, const Shutter &of_scene, const Shutter &of_camera) {
    Scene scene = scene_of(integrator);
    scene.film.spp = 256;
    scene.integrator.light_samples = 0;
    scene.shutter = of_scene, scene.cameras[0].shutter = of_camera;
    move(scene, ball(scene, add_material(scene, emitter(Spectrum(1))), 1), translation({-2, -0.5, 0}), translation({2, 1, 0}));
    return scene;
}

}  // namespace

/// Over its way a ball that shines is as bright everywhere as it covers pixel and time.
TEST_P(MovingBall, CoversPixelsAsLongAsItIsThere) {
    const Scene scene = shining_ball(GetParam(), {0, 1}, {0, 1});
    expect_coverage(scene, render_scene(scene).picture, {-2, -0.5}, {2, 1}, 1);
}

/// Without packets: rays go through a grid one by one.
TEST(SingleRays, MeetAMovingBallAsLongAsItIsThere) {
    Scene scene = shining_ball("whitted", {0, 1}, {0, 1});
    scene.accelerator = "uniform_grid";
    expect_coverage(scene, render_scene(scene).picture, {-2, -0.5}, {2, 1}, 1);
}

TEST_P(MovingBall, IsSeenAsLongAsTheShutterIsOpen) {
    const Scene scene = shining_ball(GetParam(), {-1, 1}, {0, 0.5});
    expect_coverage(scene, render_scene(scene).picture, {-2, -0.5}, {0, 0.25}, 1);
}

/// Its shadow goes with it: what is seen is a white wall behind it, but for where light from in front does not reach.
TEST_P(MovingBall, ItsShadowMovesWithIt) {
    Scene scene = scene_of(GetParam());
    scene.film.spp = 256;
    scene.integrator.max_depth = 1;
    scene.materials[0] = {"white", matte(1), ""};
    add_triangle(scene, 0, {-20, -20, 0}, {20, -20, 0}, {0, 30, 0});
    scene.lights.push_back(directional_light(glm::normalize(vec3(0, 0, 1)), Spectrum(float(glm::pi<double>()))));
    scene.cameras[0].from = {0, 0, 5};  // the ball is behind the eye, in front of the wall
    move(scene, ball(scene, 0, 1), translation({-2, -0.5, 8}), translation({2, 1, 8}));
    std::vector<vec3> picture = render_scene(scene).picture;
    for (vec3 &pixel : picture) pixel = vec3(1) - pixel;
    expect_coverage(scene, picture, {-2, -0.5}, {2, 1}, 1);
}

INSTANTIATE_TEST_SUITE_P(Motion, MovingBall, testing::Values("whitted", "path"), [](const auto &info) { return std::string(info.param); });

namespace {

/// A bar that turns and shines, or is seen by the light of a lamp beside it.
Scene turning_bar(const Shutter &shutter, bool shines) {
    Scene scene = shining_scene();
    scene.shutter = shutter, scene.cameras[0].shutter = shutter;
    if (!shines) scene.integrator.light_samples = 1, scene.lights.push_back(point_light({1, 0.5f, 2}, Spectrum(40)));
    const AffineMap end = then(rotation(110, {0.2, 0.1, 1}), translation({0.5, -0.3, 0}));
    move(scene, bar(scene, shines ? 1 : 0), translation({-1, 0, 0}), end);
    return scene;
}

}  // namespace

TEST(MovingPictures, AreTheMeanOfStillOnes) {
    for (const bool shines : {true, false}) {
        const auto expected = mean_of_stills([&](double time) { return turning_bar({time, time}, shines); });
        const auto found = blocks_of(turning_bar({0, 1}, shines));
        EXPECT_TRUE(statistics::plausible(statistics::p_of_differences(found, expected))) << (shines ? "shines" : "is lit");
        const auto seen = std::ranges::count_if(expected, [](const statistics::Estimate &e) { return e.mean > 0.02; });
        EXPECT_GT(seen, 5) << (shines ? "shines" : "is lit");
    }
}

namespace {

/// A lamp over a floor that is seen at the origin, from which it is nearer and turned otherwise later.
Scene moving_lamp(const std::function<void(Scene &)> &add) {
    Scene scene = irradiance::scene_seen_at({0.3f, 0.12f, -0.5f}, {0, 0, 0});
    scene.shutter = {0, 1}, scene.cameras[0].shutter = scene.shutter;
    scene.film.sampler = kind_number(sampler_kinds(), "independent");
    scene.film.width = 64, scene.film.height = 64, scene.film.spp = 256;
    const uint group = group_of(scene, add);
    const AffineMap end = then(then(rotation(70, {1, 2, 3}), scaling({0.5, 1.2, 2})), translation({0.8, 1.6, 0}));
    move(scene, group, translation({-1, 3, 0.3}), end);
    irradiance::add_floor(scene);
    return scene;
}

}  // namespace

/// As long as lamps are asked where they are, asking, finding them by chance, and both weighted agree.
TEST(MovingLamps, GiveWhatIsFoundOfThemByChance) {
    const std::vector<std::function<void(Scene &)>> lamps = {
        [](Scene &scene) {
            add_sphere(scene, 1, {0.2f, 0, 0}, 0.8f);
        },
        [](Scene &scene) {
            irradiance::add_quad(scene, 1, {-1, 0, -1}, {2, 0.5f, 0}, {0, 0, 1});
        },
        [](Scene &scene) {
            add_frustum(scene, 1, {-1, 0, 0}, 0.3f, {1, 0.2f, 0.5f}, 0.1f);
        },
    };
    for (const auto &lamp : lamps) {
        Scene scene = moving_lamp(lamp);
        const irradiance::Estimate whitted = irradiance::estimate(scene);
        scene.integrator.type = "path";
        const irradiance::Estimate both = irradiance::estimate(scene);
        scene.integrator.light_samples = 0;
        const irradiance::Estimate met = irradiance::estimate(scene);
        EXPECT_TRUE(statistics::plausible(irradiance::p_of(whitted, met))) << whitted.mean << " but by chance " << met.mean;
        EXPECT_TRUE(statistics::plausible(irradiance::p_of(both, met))) << both.mean << " but by chance " << met.mean;
        for (const irradiance::Estimate &estimate : {whitted, both}) EXPECT_LT(estimate.error(), 0.003L * met.mean) << "the test can tell";
    }
}

TEST(MovingBits, AreTheSameForBatchesAndKernels) {
    Scene scene = moving_scene("whitted");
    expect_same_bits(scene);
}

namespace {

class MovingBitsOf : public testing::TestWithParam<const char *> {};

std::vector<const char *> accelerators_but_none() {
    std::vector<const char *> names;
    for (const AcceleratorKind &kind : accelerator_kinds())
        if (kind.name != std::string("none")) names.push_back(kind.name);
    return names;
}

}  // namespace

TEST_P(MovingBitsOf, AreThoseWithoutAnAccelerator) {
    Scene scene = moving_scene("path");
    scene.accelerator = "none";
    const std::uint64_t hash = film_hash(render_scene(scene).film);
    scene.accelerator = GetParam();
    EXPECT_EQ(film_hash(render_scene(scene).film), hash);
}

INSTANTIATE_TEST_SUITE_P(Accelerators, MovingBitsOf, testing::ValuesIn(accelerators_but_none()),
                         [](const auto &info) { return std::string(info.param); });

TEST(MovingBits, OfAnInstantAreThoseOfAStillScene) {
    const auto film_of = [](const Shutter &shutter, bool still) {
        Scene scene = scene_of("whitted");
        scene.shutter = shutter, scene.cameras[0].shutter = shutter;
        scene.lights.push_back(point_light({3, 4, 8}, Spectrum(80)));
        const AffineMap end = then(rotation(50, {1, 2, 3}), translation({1, 0, 0}));
        const uint group = bar(scene, 0);
        EXPECT_FALSE(still ? add_instance(scene, group, end) : add_instance(scene, group, Motion({{0, AffineMap()}, {1, end}, {2, end}})));
        return film_hash(render_scene(scene).film);
    };
    const std::uint64_t hash = film_of({}, true);
    EXPECT_EQ(film_of({1, 1}, false), hash);
    EXPECT_EQ(film_of({1, 2}, false), hash) << "it rests";
    EXPECT_NE(film_of({0.9, 0.9}, false), hash);
}

/// An instance at rest in a scene where another one moves, out of sight, goes through the same arithmetic.
TEST(MovingBits, OfWhatIsAtRestAreThoseOfAStillScene) {
    const auto film_of = [](bool moves) {
        Scene scene = scene_of("path");
        scene.lights.push_back(point_light({3, 4, 8}, Spectrum(80)));
        EXPECT_FALSE(add_instance(scene, bar(scene, 0), then(rotation(50, {1, 2, 3}), translation({1, 0, 0}))));
        const uint far_away = ball(scene, 0, 1);
        const AffineMap there = translation({0, 0, 50});
        EXPECT_FALSE(add_instance(scene, far_away, Motion({{0, there}, {1, moves ? translation({1, 0, 50}) : there}})));
        scene.cameras[0].from = {0, 0, 10};
        return film_hash(render_scene(scene).film);
    };
    EXPECT_EQ(film_of(true), film_of(false));
}
