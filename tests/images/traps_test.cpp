/// The known traps that Whitted's method can show: what it must get right, and what it must leave dark.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scene/bsdfs/bsdf.h"
#include "tests/images/oracle.h"
#include "tests/images/seen_scenes.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace {

using namespace brandung;
using oracle::Line;
using oracle::Real;
using oracle::Vec;

float largest(const std::vector<vec3> &picture) {
    float most = 0;
    for (const vec3 &pixel : picture) most = std::max({most, pixel.x, pixel.y, pixel.z});
    return most;
}

}  // namespace

// ---- light that Whitted cannot bring ---------------------------------------------------------------------------------------------------------

namespace {

/// A lamp at (-2, 1, 0) that a board keeps from shining on the table at y = 0, and a wall at x = 2 that it does shine on. The wall's mirror image of
/// the lamp, at (6, 1, 0), would light the table between x = 0.5 and 1.5 through heights 0.27 to 0.11 of the wall; there the light passes the board's
/// plane x = -1 at 0.82 to 0.78, above it. Straight light to the table passes it at 0.6 to 0.71: the board covers 0.5 to 0.75.
Scene lamp_and_table(bool with_mirror, bool seen_from_above) {
    Scene scene = seen_from_above ? scene_seen_from({1, 3, 0}, {1, 0, 0}, 12) : scene_seen_from({1, 0.2f, 0}, {2, 0.2f, 0}, 5);
    const uint table = add_material(scene, matte(0.5f)), board = add_material(scene, matte(0.5f));
    const uint wall = add_material(scene, with_mirror ? mirror(1) : matte(0.5f));
    add_floor(scene, table, 1.9f, 0);
    add_quad(scene, board, {-1, 0.5f, -2}, {-1, 0.5f, 2}, {-1, 0.75f, 2}, {-1, 0.75f, -2});
    add_quad(scene, wall, {2, 0, -2}, {2, 0, 2}, {2, 2, 2}, {2, 2, -2});
    scene.lights.push_back(point_light({-2, 1, 0}, Spectrum(10)));
    return scene;
}

}  // namespace

TEST(Traps, TableLitOnlyByAMirrorStaysDark) {
    EXPECT_EQ(largest(render_scene(lamp_and_table(true, true)).picture), 0);
    Scene other = lamp_and_table(true, true);
    other.ambient = Spectrum(0.25f);
    for (const vec3 &pixel : render_scene(other).picture)
        ASSERT_EQ(pixel, vec3(0.125f)) << "ambient light 1/4 times reflectance 1/2, and nothing else";
}

/// A point light on a sloping ceiling: no ray to it, however long, meets the ceiling around it, though rounding puts its end on either side.
TEST(Traps, ALightInTheCeilingShines) {
    for (const float far : {0.0f, 7.3f, 411.7f}) {
        Scene scene = scene_seen_from({far + 0.1f, far + 0.3f, far + 0.2f}, {far, far - 1, far}, 90);
        const uint matte_one = add_material(scene, matte(0.5f));
        add_floor(scene, matte_one, 2000, -1);
        const vec3 lamp(far + 0.7f, far + 0.9f, far - 0.4f), along(1, 0.3f, 0.2f), across(-0.1f, 0.2f, 1);
        scene.lights.push_back(point_light(lamp, Spectrum(10)));
        add_quad(scene, matte_one, lamp - along - across, lamp + along - across, lamp + along + across, lamp - along + across);
        const Rendering rendering = render_scene(scene);
        EXPECT_GT(rendering.counts.rays[RAY_SHADOW], 1000u);
        EXPECT_EQ(rendering.counts.hits[RAY_SHADOW], 0u) << far;
    }
}

TEST(Traps, TheLampDoesShineOnThatMirror) {
    for (const vec3 &pixel : render_scene(lamp_and_table(false, false)).picture)
        ASSERT_GT(pixel.x, 0.05f) << "a matte wall in the mirror's place is lit";
    Scene second = lamp_and_table(false, true);
    second.shapes.pop_back();
    second.lights = {point_light({6, 1, 0}, Spectrum(10))};
    for (const vec3 &pixel : render_scene(second).picture) ASSERT_GT(pixel.x, 0.001f) << "a lamp in the mirrored one's place lights the table";
}

TEST(Traps, LampSeenOnlyThroughGlassLightsNothing) {
    Scene scene = scene_seen_from({0, 4, 3}, {0, 0, 0}, 40);
    add_floor(scene, add_material(scene, matte(0.5f)), 8, 0);
    scene.lights.push_back(point_light({0, 2, 0}, Spectrum(10)));
    for (const vec3 &pixel : render_scene(scene).picture) ASSERT_GT(pixel.x, 0.01f) << "lit without the glass";
    add_sphere(scene, add_material(scene, glass(1.5f)), {0, 2, 0}, 0.25f);
    // What sees the floor directly or through the ball sees it dark; the ball itself has no colour.
    EXPECT_EQ(largest(render_scene(scene).picture), 0);
}

/// Light falls on the outside of transparent bodies only; through the front, the eye sees the back lit from behind.
TEST(Traps, TheInsideOfGlassShowsTheLightOnItsOutside) {
    Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0}, 60, 48);
    scene.integrator.max_depth = 2;
    Material ball = make_material(Whitted{.diffuse = Spectrum(0.5f), .transmission = Spectrum(0.75f), .exponent = 1});
    ball.eta = 1.5f;
    add_sphere(scene, add_material(scene, ball), {0, 0, 0}, 1);
    const Vec towards = glm::normalize(Vec(0.5L, 0.25L, -1));
    scene.lights.push_back(directional_light(vec3(towards), Spectrum(oracle::pi)));
    const Rendering rendering = render_scene(scene);
    std::size_t lit = 0;
    for (uint y = 0; y < 48; ++y)
        for (uint x = 0; x < 48; ++x) {
            const Line eye = oracle::eye_ray(scene, x, y);
            const auto crossings = oracle::cross_sphere(eye, Vec(0), 1);
            if (!crossings || crossings->second - crossings->first < 0.2L) continue;
            const Vec front = eye.at(crossings->first);
            const Line inner{front, *oracle::refract(eye.direction, front, 1 / 1.5L)};
            const Vec back = inner.at(oracle::cross_sphere(inner, Vec(0), 1)->second);
            const Real expected = 0.5L * std::max(0.0L, glm::dot(front, towards)) + 0.75L * 0.5L * std::max(0.0L, glm::dot(back, towards));
            ASSERT_NEAR(rendering.picture[y * 48 + x].x, expected, 2e-5L) << x << ", " << y;
            lit += glm::dot(back, towards) > 0.1L;
        }
    EXPECT_GT(lit, 200u);
}

// ---- visibility ------------------------------------------------------------------------------------------------------------------------------

TEST(Traps, OfInterpenetratingBodiesTheNearestShows) {
    Scene scene = scene_seen_from({0.5f, 2, 4}, {0, 0, 0}, 45, 100);
    const Vec centers[] = {{-0.4L, 0, 0}, {0.4L, 0.2L, 0.1L}};
    for (const Vec &center : centers) add_sphere(scene, add_material(scene, emitter(Spectrum(center.x < 0 ? 1.0f : 2.0f))), vec3(center), 0.8f);
    add_floor(scene, add_material(scene, emitter(Spectrum(4))), 1.5f, 0);
    const Rendering rendering = render_scene(scene);
    std::size_t seen[3] = {}, ties = 0;
    for (uint y = 0; y < 100; ++y)
        for (uint x = 0; x < 100; ++x) {
            const Line ray = oracle::eye_ray(scene, x, y);
            Real t[3] = {INFINITY, INFINITY, oracle::cross_plane(ray, Vec(0), Vec(0, 1, 0))};
            for (int i = 0; i < 2; ++i)
                if (const auto crossings = oracle::cross_sphere(ray, Vec(vec3(centers[i])), 0.8f)) t[i] = crossings->first;
            const Vec p = ray.at(t[2]);
            if (!(t[2] > 0) || std::abs(p.x) > 1.5L || std::abs(p.z) > 1.5L) t[2] = INFINITY;
            const int nearest = static_cast<int>(std::min_element(t, t + 3) - t);
            std::sort(t, t + 3);
            const float value = rendering.picture[y * 100 + x].x;
            if (t[0] == INFINITY) {
                ASSERT_EQ(value, 0) << x << ", " << y;
            } else if (t[1] - t[0] < 1e-5L) {
                ++ties;
            } else {
                ++seen[nearest];
                ASSERT_EQ(value, std::exp2(static_cast<float>(nearest))) << x << ", " << y;
            }
        }
    for (const std::size_t count : seen) EXPECT_GT(count, 300u) << "all three are seen";
    EXPECT_LT(ties, 5u);
}

// ---- shading normals -------------------------------------------------------------------------------------------------------------------------

namespace {

/// A ball of few facets with the normals of a sphere.
void add_faceted_ball(Scene &scene, uint material) {
    constexpr uint rings = 8, sectors = 12;
    const auto corner = [](uint ring, uint sector) {
        const double polar = std::numbers::pi * ring / rings, azimuth = 2 * std::numbers::pi * (sector % sectors) / sectors;
        const double r = ring == 0 || ring == rings ? 0 : std::sin(polar);
        return vec3(r * std::cos(azimuth), std::cos(polar), r * std::sin(azimuth));
    };
    for (uint ring = 0; ring < rings; ++ring)
        for (uint sector = 0; sector < sectors; ++sector) {
            const vec3 a = corner(ring, sector), b = corner(ring + 1, sector), c = corner(ring + 1, sector + 1), d = corner(ring, sector + 1);
            if (ring + 1 < rings) add_smooth_triangle(scene, material, a, c, b, vec3(0));
            if (ring > 0) add_smooth_triangle(scene, material, a, d, c, vec3(0));
        }
}

}  // namespace

/// Interpolated normals bend what is mirrored, but never into the body: from a convex mirror all rays leave.
TEST(ShadingNormals, MirrorNothingIntoAConvexBody) {
    for (const char *integrator : {"whitted", "path"}) {
        Scene scene = scene_seen_from({0.3f, 1, 4}, {0, 0, 0}, 32, 100);
        scene.background = Spectrum(1);
        scene.integrator.type = integrator, scene.integrator.max_depth = 4;
        add_faceted_ball(scene, add_material(scene, mirror(0.5f)));
        const Rendering rendering = render_scene(scene);
        EXPECT_GT(rendering.counts.rays[RAY_REFLECTED], 3000u) << integrator;
        EXPECT_EQ(rendering.counts.hits[RAY_REFLECTED], 0u) << integrator;
    }
}

/// For paths light from aside falls smoothly to 0 on a ball of facets, on those too that lie behind their own horizon.
TEST(ShadingNormals, LightEndsSmoothlyOnFacets) {
    Scene scene = scene_seen_from({0, 0, 6}, {0, 0, 0}, 20, 200);
    scene.integrator.type = "path", scene.integrator.max_depth = 1;
    add_faceted_ball(scene, add_material(scene, matte(1)));
    scene.lights.push_back(directional_light({0.8f, 0, 0.6f}, Spectrum(1)));  // so that the border crosses faces
    const Rendering rendering = render_scene(scene);
    float brightest = 0, steepest = 0;
    for (uint x = 30; x + 1 < 170; ++x) {
        const float here = rendering.picture[100 * 200 + x].x, next = rendering.picture[100 * 200 + x + 1].x;
        brightest = std::max(brightest, here), steepest = std::max(steepest, std::abs(next - here));
    }
    EXPECT_GT(brightest, 0.2f);
    EXPECT_LT(steepest, 0.1f * brightest);
}

/// And what is refracted goes in.
TEST(ShadingNormals, RefractEverythingIntoTheBody) {
    Scene scene = scene_seen_from({0.3f, 1, 4}, {0, 0, 0}, 32, 100);
    scene.integrator.max_depth = 2;
    add_faceted_ball(scene, add_material(scene, glass(1.5f)));
    const Rendering rendering = render_scene(scene);
    EXPECT_GT(rendering.counts.rays[RAY_REFRACTED], 3000u);
    EXPECT_EQ(rendering.counts.hits[RAY_REFRACTED], rendering.counts.rays[RAY_REFRACTED]);
    EXPECT_EQ(rendering.counts.hits[RAY_REFLECTED], 0u);
}

/// Of a path none is lost at an ideal interface, on whatever side of a face the shading normal would lead it.
TEST(ShadingNormals, LoseNoPathAtGlass) {
    Scene scene = scene_seen_from({0.3f, 1, 4}, {0, 0, 0}, 32, 100);
    scene.integrator.type = "path", scene.integrator.max_depth = 1;
    add_faceted_ball(scene, add_material(scene, glass(1.5f)));
    const RayCounts counts = render_scene(scene).counts;
    EXPECT_GT(counts.hits[RAY_CAMERA], 3000u);
    EXPECT_EQ(counts.rays[RAY_REFLECTED] + counts.rays[RAY_REFRACTED], counts.hits[RAY_CAMERA]);
}
