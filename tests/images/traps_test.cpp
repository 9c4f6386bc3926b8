/// The known traps that Whitted's method can show: what it must get right, and what it must leave dark.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "scene/bsdfs/bsdf.h"
#include "scene/lights/light.h"
#include "tests/images/oracle.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace {

using namespace brandung;
using oracle::Line;
using oracle::Real;
using oracle::Vec;

Scene scene_seen_from(vec3 from, vec3 at, float degrees, uint size = 40) {
    Scene scene;
    scene.file = "trap";
    CameraDescription camera;
    camera.from = from, camera.at = at, camera.fov = glm::radians(degrees);
    camera.up = std::abs(glm::normalize(at - from).y) > 0.9f ? vec3(0, 0, -1) : vec3(0, 1, 0);
    scene.cameras.push_back(camera);
    scene.film.width = scene.film.height = size;
    return scene;
}

void add_quad(Scene &scene, uint material, vec3 a, vec3 b, vec3 c, vec3 d) {
    MeshData mesh;
    append_polygon(scene, mesh, {a, b, c, d}, {});
    add_triangle_mesh(scene, material, std::move(mesh));
}

void add_floor(Scene &scene, uint material, float half, float height) {
    add_quad(scene, material, {-half, height, half}, {half, height, half}, {half, height, -half}, {-half, height, -half});
}

/// The sides of a box, outsides outside, or inside with `inwards`.
void add_box(Scene &scene, uint material, vec3 low, vec3 high, bool inwards = false) {
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) {
            const auto corner = [&](bool u, bool v) {
                vec3 p;
                p[axis] = upper ? high[axis] : low[axis];
                const bool swap = upper == inwards;
                p[(axis + 1) % 3] = (swap ? v : u) ? high[(axis + 1) % 3] : low[(axis + 1) % 3];
                p[(axis + 2) % 3] = (swap ? u : v) ? high[(axis + 2) % 3] : low[(axis + 2) % 3];
                return p;
            };
            add_quad(scene, material, corner(false, false), corner(true, false), corner(true, true), corner(false, true));
        }
}

uint add_emitter(Scene &scene, Spectrum radiance) {
    Material material = make_material(Whitted{.exponent = 1});
    material.emission = radiance;
    return add_material(scene, material);
}

/// Lets through what Fresnel's law lets through, and reflects nothing.
uint add_clear(Scene &scene, float eta, uint priority) {
    Material material = make_material(Whitted{.transmission = Spectrum(1), .exponent = 1, .fresnel = 1});
    material.eta = eta, material.priority = priority;
    return add_material(scene, material);
}

uint add_glass(Scene &scene, float eta, uint priority) {
    Material material = glass(eta);
    material.priority = priority;
    return add_material(scene, material);
}

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
    for (const Vec &center : centers) add_sphere(scene, add_emitter(scene, Spectrum(center.x < 0 ? 1.0f : 2.0f)), vec3(center), 0.8f);
    add_floor(scene, add_emitter(scene, Spectrum(4)), 1.5f, 0);
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
    Scene scene = scene_seen_from({0.3f, 1, 4}, {0, 0, 0}, 32, 100);
    scene.background = Spectrum(1);
    scene.integrator.max_depth = 4;
    add_faceted_ball(scene, add_material(scene, mirror(0.5f)));
    const Rendering rendering = render_scene(scene);
    EXPECT_GT(rendering.counts.rays[RAY_REFLECTED], 3000u);
    EXPECT_EQ(rendering.counts.hits[RAY_REFLECTED], 0u);
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

// ---- nested glass ----------------------------------------------------------------------------------------------------------------------------

namespace {

/// A floor at y = -4 under what is looked through; its lamp is below all glass.
struct GlassOverFloor {
    explicit GlassOverFloor(uint max_depth) : scene(scene_seen_from({0.4f, 6, 0.3f}, {0, 0, 0}, 28)) {
        scene.integrator.max_depth = max_depth;
        add_floor(scene, add_material(scene, matte(0.5f)), 12, -4);
        scene.lights.push_back(point_light(vec3(lamp), Spectrum(50)));
    }
    Real floor_radiance(const Line &ray) const {
        const Vec way = lamp - ray.at(oracle::cross_plane(ray, Vec(0, -4, 0), Vec(0, 1, 0)));
        const Real d = glm::length(way);
        return 50 * 0.5L / oracle::pi * way.y / (d * d * d);
    }
    /// Expects what `radiance(ray)` gives for every eye ray, where it gives anything.
    template <class Radiance> void expect(std::size_t at_least, Radiance radiance) const {
        const Rendering rendering = render_scene(scene);
        EXPECT_EQ(rendering.refused, 0u);
        std::size_t compared = 0;
        for (uint y = 0; y < scene.film.height; ++y)
            for (uint x = 0; x < scene.film.width; ++x) {
                const std::optional<Real> expected = radiance(oracle::eye_ray(scene, x, y));
                if (!expected) continue;
                ++compared;
                // The floor's lit point is off by 12 2^-21, and by what bent rays add over their way.
                ASSERT_NEAR(rendering.picture[y * scene.film.width + x].x, *expected, 2e-4L * *expected) << x << ", " << y;
            }
        EXPECT_GE(compared, at_least);
    }

    const Vec lamp{2, -2.5L, 1};
    Scene scene;
};

/// Through a level interface at `height` into a medium of index `beyond`; what passes is multiplied into `part`.
Line through_level(const Line &ray, Real height, Real index, Real beyond, Real &part) {
    const Vec p = ray.at(oracle::cross_plane(ray, Vec(0, height, 0), Vec(0, 1, 0)));
    part *= 1 - oracle::fresnel(-ray.direction.y, index / beyond);
    return {p, *oracle::refract(ray.direction, Vec(0, 1, 0), index / beyond)};
}

/// Expects what glass from 0.5 down to `border` and water from there down to -1 let through.
void expect_glass_on_water(const GlassOverFloor &test, Real border) {
    test.expect(1600, [&](const Line &eye) -> std::optional<Real> {
        Real part = 1;
        const Line in_glass = through_level(eye, 0.5L, 1, 1.5f, part), in_water = through_level(in_glass, border, 1.5f, 1.33f, part);
        const Line below = through_level(in_water, -1, 1.33f, 1, part);
        return part * test.floor_radiance(below);
    });
}

/// Expects what glass from 0.5 down to -1 lets through.
void expect_glass(const GlassOverFloor &test) {
    test.expect(1600, [&](const Line &eye) -> std::optional<Real> {
        Real part = 1;
        const Line inside = through_level(eye, 0.5L, 1, 1.5f, part), below = through_level(inside, -1, 1.5f, 1, part);
        return part * test.floor_radiance(below);
    });
}

}  // namespace

/// Glass down to -0.5 in water up to 0: the water's surface inside the glass is none. Depth 4 suffices: passing it costs nothing.
TEST(NestedGlass, HigherPriorityHidesTheOthersSurface) {
    GlassOverFloor test(4);
    const uint water = add_clear(test.scene, 1.33f, 0), glass = add_clear(test.scene, 1.5f, 1);
    add_box(test.scene, water, {-9, -1, -9}, {9, 0, 9});
    add_box(test.scene, glass, {-8, -0.5f, -8}, {8, 0.5f, 8});
    expect_glass_on_water(test, -0.5L);
}

/// The other way round the glass ends where the water begins.
TEST(NestedGlass, LowerPriorityIsHidden) {
    GlassOverFloor test(4);
    const uint water = add_clear(test.scene, 1.33f, 2), glass = add_clear(test.scene, 1.5f, 1);
    add_box(test.scene, water, {-9, -1, -9}, {9, 0, 9});
    add_box(test.scene, glass, {-8, -0.5f, -8}, {8, 0.5f, 8});
    expect_glass_on_water(test, 0);
}

/// Liquids are modelled overlapping their glass a little (Schmidt and Budge, Simple Nested Dielectrics in Ray Traced Images, JGT 7(2) 2002): then
/// they touch without a gap.
TEST(NestedGlass, LiquidThatOverlapsItsGlassTouchesIt) {
    GlassOverFloor test(4);
    const uint water = add_clear(test.scene, 1.33f, 0), glass = add_clear(test.scene, 1.5f, 1);
    add_box(test.scene, water, {-9, -1, -9}, {9, 0.001f, 9});
    add_box(test.scene, glass, {-8, 0, -8}, {8, 0.5f, 8});
    expect_glass_on_water(test, 0);
}

/// Of equal priorities the material that was declared first counts: the glass ends where the water begins.
TEST(NestedGlass, OfEqualPrioritiesTheFirstHides) {
    GlassOverFloor test(4);
    const uint water = add_clear(test.scene, 1.33f, 0), glass = add_clear(test.scene, 1.5f, 0);
    add_box(test.scene, glass, {-8, -0.5f, -8}, {8, 0.5f, 8});
    add_box(test.scene, water, {-9, -1, -9}, {9, 0, 9});
    expect_glass_on_water(test, 0);
}

/// Where two faces are the same plane there is one interface, in either order of the objects, and even where their diagonals coincide.
struct Touching {
    bool water_first, same_size;
};
class TouchingGlass : public testing::TestWithParam<Touching> {};

TEST_P(TouchingGlass, HasOneInterfaceWhereFacesCoincide) {
    const auto [water_first, same_size] = GetParam();
    GlassOverFloor test(4);
    const uint water = add_clear(test.scene, 1.33f, 0), glass = add_clear(test.scene, 1.5f, 0);
    const float size = same_size ? 8.0f : 9.0f;
    if (water_first) add_box(test.scene, water, {-size, -1, -size}, {size, 0, size});
    add_box(test.scene, glass, {-8, 0, -8}, {8, 0.5f, 8});
    if (!water_first) add_box(test.scene, water, {-size, -1, -size}, {size, 0, size});
    expect_glass_on_water(test, 0);
}

INSTANTIATE_TEST_SUITE_P(NestedGlass, TouchingGlass,
                         testing::Values(Touching{true, false}, Touching{true, true}, Touching{false, false}, Touching{false, true}),
                         [](const auto &info) {
                             return std::string(info.param.water_first ? "WaterFirst" : "GlassFirst") + (info.param.same_size ? "SameSize" : "");
                         });

/// Two boxes of one material that touch are one body.
TEST(NestedGlass, TouchingBodiesOfOneMaterialHaveNoInnerInterface) {
    GlassOverFloor test(3);
    const uint clear = add_clear(test.scene, 1.5f, 0);
    add_box(test.scene, clear, {-9, -1, -9}, {9, 0, 9});
    add_box(test.scene, clear, {-8, 0, -8}, {8, 0.5f, 8});
    expect_glass(test);
}

/// Glass that stands on the floor does not hide it, whichever of the coincident faces comes first.
TEST(NestedGlass, WhatIsOpaqueCountsWhereGlassTouchesIt) {
    for (const bool glass_first : {false, true}) {
        Scene scene = scene_seen_from({0.4f, 6, 0.3f}, {0, 0, 0}, 28);
        scene.integrator.max_depth = 3;
        const uint clear = add_clear(scene, 1.5f, 0), floor = add_emitter(scene, Spectrum(2));
        if (glass_first) add_box(scene, clear, {-9, 0, -9}, {9, 0.5f, 9});
        add_floor(scene, floor, 12, 0);
        if (!glass_first) add_box(scene, clear, {-9, 0, -9}, {9, 0.5f, 9});
        const Rendering rendering = render_scene(scene);
        for (uint y = 0; y < scene.film.height; ++y)
            for (uint x = 0; x < scene.film.width; ++x) {
                Real part = 1;
                through_level(oracle::eye_ray(scene, x, y), 0.5L, 1, 1.5f, part);
                ASSERT_NEAR(rendering.picture[y * scene.film.width + x].x, 2 * part, 1e-5L) << x << ", " << y;
            }
    }
}

/// However many interfaces are hidden, a ray passes them all.
TEST(NestedGlass, ManyHiddenInterfacesArePassed) {
    GlassOverFloor test(3);
    const uint hidden = add_clear(test.scene, 2.0f, 0), clear = add_clear(test.scene, 1.5f, 1);
    add_box(test.scene, clear, {-9, -1, -9}, {9, 0.5f, 9});
    for (int i = 0; i < 20; ++i) {
        const float low = -0.9f + 0.06f * static_cast<float>(i);
        add_box(test.scene, hidden, {-8, low, -8}, {8, low + 0.03f, 8});
    }
    expect_glass(test);
}

/// A ray's list holds eight media; what is entered beyond is left out, and counted.
TEST(NestedGlass, MediaBeyondEightAreCounted) {
    for (const uint media : {8u, 10u}) {
        GlassOverFloor test(3);
        for (uint m = 0; m < media; ++m) {
            const float size = 8 - 0.1f * static_cast<float>(m);
            add_box(test.scene, add_clear(test.scene, 1.5f, 0), {-size, -0.1f * size, -size}, {size, 0.1f * size, size});
        }
        const Rendering rendering = render_scene(test.scene);
        EXPECT_EQ(rendering.media_lost > 0, media > 8) << media;
    }
}

/// Two balls of one material that run into each other are one body: rays bend where they enter and leave it, not at the walls inside.
TEST(NestedGlass, OverlappingBodiesOfOneMaterialHaveNoInnerInterface) {
    GlassOverFloor test(3);  // eye ray, inside, outside
    const uint clear = add_clear(test.scene, 1.5f, 0);
    const Vec centers[] = {{0, 0.5L, 0}, {0.25L, -0.5L, 0}};
    for (const Vec &center : centers) add_sphere(test.scene, clear, vec3(center), 1);
    std::size_t through_both = 0;
    test.expect(300, [&](const Line &eye) -> std::optional<Real> {
        const auto crossings = [&](const Line &line, int i) { return oracle::cross_sphere(line, centers[i], 1); };
        const auto a = crossings(eye, 0), b = crossings(eye, 1);
        if (!a && !b) return {};
        const int first = !b || (a && a->first < b->first) ? 0 : 1, other = 1 - first;
        const Vec p = eye.at((first == 0 ? a : b)->first);
        const Vec normal = p - centers[first];
        if (-glm::dot(eye.direction, normal) < 0.3L) return {};  // grazing
        const Line inner{p, *oracle::refract(eye.direction, normal, 1 / 1.5L)};
        const Real leaves_first = crossings(inner, first)->second;
        const auto second = crossings(inner, other);
        const bool goes_over = second && second->first < leaves_first - 1e-3L && second->second > leaves_first + 1e-3L;
        if (second && !goes_over && std::abs(second->second - leaves_first) < 1e-3L) return {};  // through the seam
        const Vec q = inner.at(goes_over ? second->second : leaves_first);
        const Vec inner_normal = centers[goes_over ? other : first] - q;
        const auto direction = oracle::refract(inner.direction, inner_normal, 1.5L);
        if (!direction || direction->y > -0.3L || -glm::dot(inner.direction, inner_normal) < 0.5L) return {};
        const Line out{q, *direction};
        for (int i = 0; i < 2; ++i)
            if (const auto again = crossings(out, i)) {
                if (again->first > -0.01L && again->second > 0.01L) return {};  // into the other one
            }
        const Vec end = out.at(oracle::cross_plane(out, Vec(0, -4, 0), Vec(0, 1, 0)));
        if (std::abs(end.x) > 11 || std::abs(end.z) > 11) return {};
        through_both += goes_over;
        const Real part =
            (1 - oracle::fresnel(-glm::dot(eye.direction, normal), 1 / 1.5L)) * (1 - oracle::fresnel(-glm::dot(inner.direction, inner_normal), 1.5L));
        return part * test.floor_radiance(out);
    });
    EXPECT_GT(through_both, 30u);
}

namespace {

/// A glass box with a bubble in it, before a lit floor and in a bright background, all reflections traced.
Scene box_with_bubble(bool by_priority) {
    Scene scene = scene_seen_from({2, 2.5f, 4}, {0, 0, 0}, 30, 60);
    scene.integrator.max_depth = 8;
    scene.background = {0.3f, 0.5f, 0.9f};
    add_floor(scene, add_material(scene, matte(0.5f)), 6, -1.5f);
    scene.lights.push_back(point_light({3, 4, 1}, Spectrum(30)));
    const uint glass = add_glass(scene, 1.5f, 0), air = add_glass(scene, 1, 1);
    add_box(scene, glass, vec3(-1), vec3(1));
    if (by_priority) {
        add_box(scene, air, {-0.6f, -0.5f, -0.4f}, {0.5f, 0.6f, 0.7f});
    } else {
        add_box(scene, glass, {-0.6f, -0.5f, -0.4f}, {0.5f, 0.6f, 0.7f}, true);
    }
    return scene;
}

}  // namespace

/// The hand-made interface is a wall of the glass whose outside is the bubble: what leaves the glass there enters nothing.
TEST(NestedGlass, BubbleByPriorityIsAHoleInTheGlass) {
    const Rendering priority = render_scene(box_with_bubble(true)), by_hand = render_scene(box_with_bubble(false));
    EXPECT_EQ(priority.counts.rays[RAY_REFRACTED], by_hand.counts.rays[RAY_REFRACTED]);
    EXPECT_EQ(priority.counts.rays[RAY_REFLECTED], by_hand.counts.rays[RAY_REFLECTED]);
    EXPECT_GT(priority.counts.rays[RAY_REFRACTED], 5000u);
    for (std::size_t i = 0; i < priority.picture.size(); ++i)
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(priority.picture[i][c], by_hand.picture[i][c], 1e-5f) << "pixel " << i;
    Scene without = box_with_bubble(true);
    for (int side = 0; side < 6; ++side) without.shapes.pop_back();
    EXPECT_NE(film_hash(render_scene(without).film), film_hash(priority.film)) << "the bubble is seen";
}

/// An air bubble of low priority in glass is not there.
TEST(NestedGlass, BubbleOfLowerPriorityIsNotSeen) {
    Scene hidden = box_with_bubble(true);
    hidden.materials.at(2).record.priority = 0, hidden.materials.at(1).record.priority = 1;
    Scene without = box_with_bubble(true);
    for (int side = 0; side < 6; ++side) without.shapes.pop_back();
    const Rendering a = render_scene(hidden), b = render_scene(without);
    for (std::size_t i = 0; i < a.picture.size(); ++i)
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(a.picture[i][c], b.picture[i][c], 2e-4f * (1 + b.picture[i][c])) << "pixel " << i;
}

/// A ball of glass inside a ball of the same glass is not seen either.
TEST(NestedGlass, BallInABallOfTheSameGlassIsNotSeen) {
    Scene scene = scene_seen_from({0, 0, 4}, {0, 0, 0}, 40, 60);
    scene.background = {0.3f, 0.5f, 0.9f};
    scene.integrator.max_depth = 6;
    const uint glass = add_glass(scene, 1.5f, 0);
    add_sphere(scene, glass, {0, 0, 0}, 1);
    const Rendering alone = render_scene(scene);
    add_sphere(scene, glass, {0.1f, 0.2f, 0}, 0.5f);
    const Rendering both = render_scene(scene);
    for (std::size_t i = 0; i < alone.picture.size(); ++i)
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(alone.picture[i][c], both.picture[i][c], 2e-5f) << "pixel " << i;
    EXPECT_GT(both.counts.rays[RAY_REFRACTED], alone.counts.rays[RAY_REFRACTED]) << "rays that pass the inner one";
}

/// From inside the glass the eye sees out as the ray that goes the other way sees in.
TEST(NestedGlass, TheEyeMayBeInTheGlass) {
    GlassOverFloor test(2);
    const uint clear = add_clear(test.scene, 1.5f, 0);
    test.scene.materials.back().name = "glass";
    add_box(test.scene, clear, {-9, -1, -9}, {9, 7, 9});
    test.scene.cameras[0].inside = {"glass"};
    test.expect(1600, [&](const Line &eye) -> std::optional<Real> {
        Real part = 1;
        return part * test.floor_radiance(through_level(eye, -1, 1.5f, 1, part)) * 1.0L;
    });
}
