/// Cameras that move while the shutter is open.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "scene/bsdfs/bsdf.h"
#include "scene/cameras/camera.h"
#include "scene/kinds.h"
#include "tests/images/moving_scenes.h"
#include "tests/support/rendering.h"
#include "tests/support/statistics/significance.h"

using namespace brandung;
using namespace brandung::motion;

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
