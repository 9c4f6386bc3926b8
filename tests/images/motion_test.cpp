/// Renders of what moves while the shutter is open: what analysis and still pictures at single times say of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>
#include <tuple>
#include <utility>

#include "scene/accelerators/accelerator.h"
#include "scene/bsdfs/bsdf.h"
#include "scene/cameras/camera.h"
#include "scene/kinds.h"
#include "scene/samplers/sampler.h"
#include "tests/images/irradiance.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"
#include "tests/support/statistics/blocks.h"
#include "tests/support/statistics/significance.h"

namespace {

using namespace brandung;

constexpr uint width = 32, height = 24;

/// Seen from the front, without perspective: a pixel is 1/4 wide.
Scene scene_of(const std::string &integrator) {
    Scene scene;
    scene.file = "motion";
    scene.shutter = {0, 1};
    scene.cameras.push_back(
        {.name = "camera", .from = {0, 0, 10}, .at = {0, 0, 0}, .kind = kind_number(camera_kinds(), "orthographic"), .height = 6});
    scene.cameras[0].shutter = scene.shutter;
    scene.film.width = width, scene.film.height = height, scene.film.spp = 64;
    scene.integrator.type = integrator;
    add_material(scene, matte(0.5f));
    return scene;
}

/// What the group consists of is added to the scene by `add`.
template <class Add> uint group_of(Scene &scene, const Add &add) {
    auto world = std::exchange(scene.shapes, {});
    add(scene);
    return add_group(scene, "group", std::exchange(scene.shapes, std::move(world)));
}

uint ball(Scene &scene, uint material, float radius) {
    return group_of(scene, [&](Scene &s) { add_sphere(s, material, {0, 0, 0}, radius); });
}

uint bar(Scene &scene, uint material) {
    return group_of(scene, [&](Scene &s) {
        add_triangle(s, material, {-2, -0.15f, 0}, {2, -0.15f, 0}, {2, 0.15f, 0.1f});
        add_triangle(s, material, {-2, -0.15f, 0}, {2, 0.15f, 0.1f}, {-2, 0.15f, 0.1f});
        add_sphere(s, material, {1.8f, 0, 0}, 0.3f);
    });
}

void move(Scene &scene, uint group, const AffineMap &from, const AffineMap &to) {
    ASSERT_FALSE(add_instance(scene, group, Motion({{0, from}, {1, to}})));
}

/// Bars and balls in different instances that move in different ways, and one that does not.
Scene moving_scene(const std::string &integrator) {
    Scene scene = scene_of(integrator);
    scene.film.spp = 4;
    scene.background = Spectrum(0.3f);
    scene.lights.push_back(directional_light(glm::normalize(vec3(1, 2, 3)), Spectrum(1)));
    const uint shiny = add_material(scene, mirror(0.8f)), clear = add_material(scene, glass(1.5f));
    move(scene, bar(scene, 0), rotation(-40, {0, 0, 1}), rotation(100, {0, 0, 1}));
    move(scene, ball(scene, shiny, 0.7f), translation({-3, 1, -1}), then(scaling({2, 1, 0.5}), translation({1, 1, -1})));
    move(scene, ball(scene, clear, 0.8f), translation({1, -2, 2}), translation({2, 0, 2}));
    move(scene, bar(scene, add_material(scene, emitter(Spectrum(2)))), translation({0, 4, 0}), then(rotation(30, {0, 0, 1}), translation({1, 3, 0})));
    EXPECT_FALSE(add_instance(scene, ball(scene, 0, 0.9f), translation({0, -2, 0})));
    add_sphere(scene, 0, {0, 0, -4}, 2);
    return scene;
}

double luminance(vec3 v) { return double(v.x + v.y + v.z) / 3; }

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

std::vector<statistics::Estimate> blocks_of(const Scene &scene) {
    return statistics::estimates_of_blocks(render_scene(scene).film, width, {4, 4}, 0);
}

/// Of what still scenes show at many times, each one of its own, anywhere in its part of those from 0 to 1.
std::vector<statistics::Estimate> mean_of_stills(const std::function<Scene(double time)> &at) {
    constexpr uint times = 64;
    Random random(5);
    std::vector<std::vector<statistics::Estimate>> stills;
    for (uint i = 0; i < times; ++i) {
        Scene still = at((i + double(random.uniform(0, 1))) / times);
        still.film.spp = 16, still.film.seed = i + 1;
        const auto blocks = blocks_of(still);
        stills.resize(blocks.size());
        for (std::size_t b = 0; b < blocks.size(); ++b) stills[b].push_back(blocks[b]);
    }
    std::vector<statistics::Estimate> result;
    for (const auto &blocks : stills) result.push_back(statistics::mean_of(blocks));
    // What the stills' own times add, one anywhere in each 64th, is not in the estimates: within that what is seen moves by a quarter of a pixel at
    // most, so that a block's mean changes by less than a tenth.
    for (statistics::Estimate &estimate : result) estimate.variance += 0.1 * 0.1 / (12.0 * times);
    return result;
}

/// What moves is seen because it shines; it gives no light.
Scene shining_scene() {
    Scene scene = scene_of("path");
    scene.integrator.light_samples = 0, scene.film.spp = 1024;
    add_material(scene, emitter(Spectrum(1)));
    return scene;
}

}  // namespace

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

namespace {

/// How many pixels differ by more than a few samples do.
uint differing(const std::vector<vec3> &a, const std::vector<vec3> &b) {
    uint count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += std::abs(luminance(a[i]) - luminance(b[i])) > 0.01;
    return count;
}

/// A ball and a bar about z = -6, seen from the origin; both, or the camera, move.
Scene seen_from_origin(const Motion &motion) {
    Scene scene = scene_of("whitted");
    scene.film.spp = 64;
    CameraDescription &camera = scene.cameras[0];
    camera.kind = 0, camera.fov = glm::radians(50.0f), camera.from = {0, 0, 0}, camera.at = {0, 0, -1};
    scene.ambient = Spectrum(1);
    const Material faint = make_material(Whitted{.ambient = Spectrum(1), .exponent = 1});
    const uint shown = add_material(scene, faint);
    const uint group = group_of(scene, [&](Scene &s) {
        add_sphere(s, shown, {-1, 0.5f, -6}, 0.8f);
        add_triangle(s, shown, {0, -1, -5}, {2, -1, -6}, {1, 1.5f, -7});
    });
    EXPECT_FALSE(add_instance(scene, group, motion));
    return scene;
}

}  // namespace

TEST(MovingCamera, SeesWhatAWorldThatMovesBackShows) {
    const AffineMap still;
    for (const auto &[there, from, at] :
         {std::tuple{translation({-1.5, 0.4, 0.2}), vec3(1.5f, -0.4f, -0.2f), vec3(1.5f, -0.4f, -1.2f)},
          std::tuple{rotation(30, {0, 1, 0}), vec3(0), vec3(std::sin(glm::radians(30.0f)), 0, -std::cos(glm::radians(30.0f)))}}) {
        const Scene world = seen_from_origin(Motion({{0, still}, {1, there}}));
        Scene camera = seen_from_origin(Motion({{0, still}}));
        camera.cameras[0].keys = {{0, {0, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {1, from, at, {0, 1, 0}}};
        const std::vector<vec3> moved = render_scene(world).picture, seen = render_scene(camera).picture;
        EXPECT_LT(differing(seen, moved), 4u) << "a sample may fall to the other side of an edge";
        EXPECT_GT(differing(seen, render_scene(seen_from_origin(Motion({{0, still}}))).picture), 100u) << "the camera moves";
    }
}

TEST(MovingCamera, OfEveryKindStandsStillWhereItsKeysAreOne) {
    for (const CameraKind &kind : camera_kinds()) {
        Scene scene = moving_scene("whitted");
        CameraDescription &camera = scene.cameras[0];
        camera.kind = uint(&kind - camera_kinds().data()), camera.horizontal_fov = 3, camera.lens = {.radius = 0.1f, .focus_distance = 8};
        const std::vector<vec3> still = render_scene(scene).picture;
        camera.keys = {{0, camera.from, camera.at, camera.up}, {1, camera.from, camera.at, camera.up}};
        EXPECT_LT(differing(render_scene(scene).picture, still), 40u) << kind.name;
        EXPECT_GT(differing(still, std::vector<vec3>(still.size(), scene.background)), 40u) << kind.name;
    }
}

namespace {

/// A thin lens that turns at an even pace while it goes straight on, as it is at a time.
CameraKey key_of_lens(double time) {
    const double angle = glm::radians(65 - 10 * time);
    const glm::dvec3 from(4.5 + 0.5 * time, 0.2 * time, 2.5 - 0.3 * time), forward(-std::sin(angle), 0, -std::cos(angle));
    return {time, vec3(from), vec3(from + forward), {0, 1, 0}};
}

/// Balls before the sharp plane, in it, and behind.
Scene seen_by_lens(const std::vector<CameraKey> &keys) {
    Scene scene = shining_scene();
    for (const auto &[x, z] : {std::pair{0.0f, 0.0f}, {2.0f, 2.0f}, {-5.0f, -2.0f}}) add_sphere(scene, 1, {x, 0.3f * z, z}, 0.5f);
    CameraDescription &camera = scene.cameras[0];
    camera.kind = kind_number(camera_kinds(), "thin_lens"), camera.fov = glm::radians(40.0f);
    camera.lens = {.radius = 1, .focus_distance = 5};
    camera.from = keys[0].from, camera.at = keys[0].at, camera.up = keys[0].up;
    if (keys.size() > 1) camera.keys = keys;
    return scene;
}

}  // namespace

/// Points of the lens turn and go with it, whatever the time of their ray.
TEST(MovingLens, ShowsTheMeanOfLensesAtRest) {
    const auto found = blocks_of(seen_by_lens({key_of_lens(0), key_of_lens(1)}));
    const auto expected = mean_of_stills([](double time) { return seen_by_lens({key_of_lens(time)}); });
    EXPECT_TRUE(statistics::plausible(statistics::p_of_differences(found, expected)));
    const auto partial = std::ranges::count_if(expected, [](const statistics::Estimate &e) { return e.mean > 0.02 && e.mean < 0.98; });
    EXPECT_GT(partial, 15) << "there is something to compare";
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
