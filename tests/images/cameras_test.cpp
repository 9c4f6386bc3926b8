/// Pictures of cameras that are no pinholes.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "scene/accelerators/accelerator.h"
#include "scene/vectors.h"
#include "tests/support/cameras.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

/// Of all kinds of primitives, with mirrors, under a light.
Scene soup_scene(const CameraDescription &camera) {
    Scene scene = empty_scene();
    scene.cameras = {camera};
    scene.film.width = 48, scene.film.height = 40, scene.film.spp = 4;
    add_soup(scene, add_material(scene, mirror(0.5f)), {.of_each = 40, .size = 0.4f});
    add_soup(scene, 0, {.of_each = 40, .size = 0.4f, .seed = 2});
    scene.lights.push_back(point_light({2, 4, 3}, Spectrum(30)));
    scene.background = Spectrum(0.3f, 0.2f, 0.1f);
    return scene;
}

class PictureOf : public testing::TestWithParam<std::string> {};

}  // namespace

/// Rays of a packet have origins of their own here.
TEST_P(PictureOf, HasTheSameBitsWhateverTheAcceleratorAndTheBatch) {
    for (const char *integrator : {"whitted", "path", "distributed"}) {
        Scene scene = soup_scene(camera_of_kind(GetParam()));
        scene.integrator.type = integrator;
        const Rendering expected = render_scene(scene);
        EXPECT_GT(expected.counts.hits[RAY_CAMERA], 200u);
        for (const AcceleratorKind &kind : accelerator_kinds()) {
            scene.accelerator = kind.name;
            const Rendering found = render_scene(scene, {.batch = 1000});
            EXPECT_EQ(film_hash(found.film), film_hash(expected.film)) << integrator << ", " << kind.name;
            EXPECT_EQ(found.counts.rays, expected.counts.rays) << integrator << ", " << kind.name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Cameras, PictureOf, testing::ValuesIn(camera_names()), [](const auto &info) { return info.param; });

TEST(Fisheye, OutsideItsCircleIsNothing) {
    Scene scene = empty_scene();
    scene.cameras = {camera_of_kind("fisheye")};
    scene.film.width = 48, scene.film.height = 40;
    scene.background = Spectrum(0.5f);
    std::uint64_t inside = 0;
    const Rendering rendering = render_scene(scene);
    for (uint y = 0; y < 40; ++y)
        for (uint x = 0; x < 48; ++x) {
            const bool seen = std::hypot(x + 0.5 - 24, y + 0.5 - 20) <= 20;
            inside += seen;
            const vec3 pixel = rendering.picture[y * 48 + x];
            ASSERT_EQ(largest(pixel) > 0, seen) << x << ", " << y;
            ASSERT_EQ(rendering.film[y * 48 + x].counts[0], 1u);
        }
    EXPECT_EQ(rendering.counts.rays[RAY_CAMERA], inside);
}

/// Whole batches without any ray.
TEST(Fisheye, APictureBesideItsCircleIsBlack) {
    Scene scene = soup_scene(camera_of_kind("fisheye"));
    scene.film.width = 200;
    scene.film.crop = Window{0, 0, 30, 40};
    for (const char *integrator : {"whitted", "path"}) {
        scene.integrator.type = integrator;
        const Rendering rendering = render_scene(scene);
        for (const vec3 pixel : rendering.picture) ASSERT_EQ(pixel, vec3(0));
        EXPECT_EQ(rendering.counts.total(), 0u);
    }
}

namespace {

/// Along the picture's axes, in pixels.
struct Spread {
    double width, height;  ///< standard deviations
    double farthest;       ///< of a pixel that is not black, from the middle
};

Spread spread_of(const Rendering &rendering, uint side) {
    double sum = 0, xx = 0, yy = 0, farthest = 0;
    for (uint i = 0; i < side * side; ++i) {
        const double x = i % side + 0.5 - side / 2.0, y = i / side + 0.5 - side / 2.0, light = double(rendering.picture[i].x);
        sum += light, xx += light * x * x, yy += light * y * y;
        if (light > 0) farthest = std::max(farthest, std::hypot(x, y));
    }
    return {std::sqrt(xx / sum), std::sqrt(yy / sum), farthest};
}

constexpr uint side = 96;
constexpr float lens_radius = 0.1f, focus = 4, fov = 20;
constexpr float ball = 0.01f;                                                       ///< radius, over its distance
const double scale = side / (2 * focus * std::tan(glm::radians(double(fov)) / 2));  ///< of the sharp plane in the picture [pixels]

/// The diameter c = A |d - f| / d in the sharp plane, for a lens of diameter A [pixels].
double circle_of_confusion(float distance) { return 2 * double(lens_radius) * std::abs(distance - focus) / distance * scale; }

/// A ball that shines, at a distance in front of a lens.
Scene lens_scene(float distance, uint blades, const std::string &integrator) {
    Scene scene = empty_scene();
    CameraDescription camera = camera_of_kind("thin_lens");
    camera.from = {1, 2, 3}, camera.at = {1, 2, -7}, camera.up = {0, 1, 0}, camera.fov = glm::radians(fov);
    camera.lens = {.radius = lens_radius, .focus_distance = focus, .blades = blades};
    scene.cameras = {camera};
    scene.film.width = scene.film.height = side, scene.film.spp = 512;
    scene.integrator.type = integrator;
    add_sphere(scene, add_material(scene, emitter(Spectrum(1))), vec3(1, 2, 3 - distance), ball * distance);
    return scene;
}

}  // namespace

/// Along an axis the variance of a disk's points is a sixteenth of its diameter's square; that of a hexagon's 5/24 of its circumradius'. Those of the
/// ball's own disk and of a pixel come to it.
TEST(ThinLens, CircleOfConfusionHasTheDiameterOfTheFormula) {
    for (const auto &[distance, blades, integrator] :
         {std::tuple(2.0f, 0u, "whitted"), {2.5f, 0u, "path"}, {16.0f, 0u, "whitted"}, {2.0f, 6u, "whitted"}, {3.0f, 0u, "distributed"}}) {
        const Spread found = spread_of(render_scene(lens_scene(distance, blades, integrator)), side);
        const double c = circle_of_confusion(distance), own = double(ball) * focus * scale;
        const auto diameter = [&](double deviation) {
            const double variance = deviation * deviation - own * own / 4 - 1.0 / 12;
            return 2 * std::sqrt(variance / (blades > 0 ? 5.0 / 24 : 0.25));
        };
        EXPECT_NEAR(diameter(found.width), c, 0.01 * c) << distance << ", " << blades;
        EXPECT_NEAR(diameter(found.height), c, 0.01 * c) << distance << ", " << blades;
        EXPECT_LE(found.farthest, c / 2 + own * 1.01 + std::sqrt(0.5)) << distance;
    }
}

namespace {

constexpr float way = 0.25f;  ///< of a camera, in its picture to the right [world units]

/// The same, elsewhere and turned, while the camera goes its way; the ball goes with it, or rests.
Scene moving_lens_scene(float distance, bool with_ball) {
    Scene scene = lens_scene(distance, 0, "whitted");
    scene.shutter = {0, 1};
    CameraDescription &camera = scene.cameras[0];
    camera.shutter = scene.shutter;
    const AffineMap turned = then(rotation(70, {1, 2, 3}), translation({-1, 0.5, 2}));
    std::vector<MotionKey> keys;
    for (const double time : {0.0, 1.0}) {
        const AffineMap map = then(translation({double(way) * (time - 0.5), 0, 0}), turned);
        const auto placed = [&](vec3 p) { return vec3(map.linear * glm::dvec3(p) + map.offset); };
        camera.keys.push_back({time, placed(camera.from), placed(camera.at), vec3(map.linear * glm::dvec3(camera.up))});
        keys.push_back({time, with_ball ? map : turned});
    }
    const uint group = add_group(scene, "ball", std::exchange(scene.shapes, {}));
    EXPECT_FALSE(add_instance(scene, group, Motion(keys)));
    return scene;
}

}  // namespace

/// A ball that goes with the lens has the circle that it has at rest; from one that rests the circle is drawn out along the way, evenly. Variances
/// add up as points of the lens and times do not know of each other.
TEST(ThinLens, CircleOfConfusionIsDrawnOutByAMotionOfTheCamera) {
    for (const float distance : {2.0f, 16.0f})
        for (const bool with_ball : {true, false}) {
            const Spread found = spread_of(render_scene(moving_lens_scene(distance, with_ball)), side);
            const double c = circle_of_confusion(distance), own = double(ball) * focus * scale;
            const double drawn_out = with_ball ? 0 : double(way) * focus / distance * scale;
            const double circle = c * c / 16 + own * own / 4 + 1.0 / 12;
            EXPECT_NEAR(found.height, std::sqrt(circle), 0.01 * std::sqrt(circle)) << distance;
            const double expected = std::sqrt(circle + drawn_out * drawn_out / 12);
            EXPECT_NEAR(found.width, expected, 0.01 * expected) << distance << (with_ball ? ", the ball moves" : ", the ball rests");
        }
}

TEST(ThinLens, WhatLiesInTheSharpPlaneIsSharp) {
    const Spread found = spread_of(render_scene(lens_scene(focus, 0, "whitted")), side);
    EXPECT_LE(found.farthest, double(ball) * focus * scale * 1.01 + std::sqrt(0.5));
}

/// An inverted picture of a far triangle-shaped aperture would point the other way.
TEST(ThinLens, ApertureIsSeenUprightBehindTheSharpPlaneAndInvertedBeforeIt) {
    for (const float distance : {2.0f, 16.0f}) {
        Scene scene = lens_scene(distance, 3, "whitted");
        scene.cameras[0].lens.blade_rotation = 90;
        const Rendering rendering = render_scene(scene);
        double upper = 0, lower = 0;
        for (uint i = 0; i < side * side; ++i) {
            const double y = side / 2.0 - (i / side + 0.5), light = double(rendering.picture[i].x);
            (y > 0 ? upper : lower) = std::max(y > 0 ? upper : lower, light > 0 ? std::abs(y) : 0);
        }
        const double own = double(ball) * focus * scale;
        if (distance < focus) std::swap(upper, lower);
        EXPECT_GT(upper - own, 1.5 * (lower - own)) << distance << ": a corner is twice as far away as a side";
    }
}

}  // namespace brandung
