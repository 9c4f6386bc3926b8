/// Where transparent bodies overlap, touch or contain each other.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

#include "scene/bsdfs/bsdf.h"
#include "tests/images/oracle.h"
#include "tests/images/seen_scenes.h"
#include "tests/scene/meshes/mesh_folder.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace {

using namespace brandung;
using oracle::Line;
using oracle::Real;
using oracle::Vec;

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

/// Expects what glass from 0.5 down to -1 lets through.
void expect_glass(const GlassOverFloor &test) {
    test.expect(1600, [&](const Line &eye) -> std::optional<Real> {
        Real part = 1;
        const Line inside = through_level(eye, 0.5L, 1, 1.5f, part), below = through_level(inside, -1, 1.5f, 1, part);
        return part * test.floor_radiance(below);
    });
}

/// Of index 1.33, from -1 up to `top`.
struct Water {
    uint priority;
    float top = 0, half_width = 9;
};
/// Of index 1.5, from 0.5 down to `bottom`.
struct Glass {
    uint priority;
    float bottom;
};

/// Expects of water, which is declared first, and glass in it or on it what they let through if the glass ends and the water begins at `border`.
void expect_border(const Water &water, const Glass &glass, Real border, bool glass_first = false) {
    GlassOverFloor test(4);
    const uint of_water = add_clear(test.scene, 1.33f, water.priority), of_glass = add_clear(test.scene, 1.5f, glass.priority);
    const float half = water.half_width;
    if (glass_first) add_box(test.scene, of_glass, {-8, glass.bottom, -8}, {8, 0.5f, 8});
    add_box(test.scene, of_water, {-half, -1, -half}, {half, water.top, half});
    if (!glass_first) add_box(test.scene, of_glass, {-8, glass.bottom, -8}, {8, 0.5f, 8});
    test.expect(1600, [&](const Line &eye) -> std::optional<Real> {
        Real part = 1;
        const Line in_glass = through_level(eye, 0.5L, 1, 1.5f, part), in_water = through_level(in_glass, border, 1.5f, 1.33f, part);
        const Line below = through_level(in_water, -1, 1.33f, 1, part);
        return part * test.floor_radiance(below);
    });
}

}  // namespace

/// Glass down to -0.5 in water up to 0: the water's surface inside the glass is none. Depth 4 suffices: passing it costs nothing.
TEST(NestedGlass, HigherPriorityHidesTheOthersSurface) { expect_border({.priority = 0}, {.priority = 1, .bottom = -0.5f}, -0.5L); }

/// The other way round the glass ends where the water begins.
TEST(NestedGlass, LowerPriorityIsHidden) { expect_border({.priority = 2}, {.priority = 1, .bottom = -0.5f}, 0); }

/// Liquids are modelled overlapping their glass a little (Schmidt and Budge, Simple Nested Dielectrics in Ray Traced Images, JGT 7(2) 2002): then
/// they touch without a gap.
TEST(NestedGlass, LiquidThatOverlapsItsGlassTouchesIt) { expect_border({.priority = 0, .top = 0.001f}, {.priority = 1, .bottom = 0}, 0); }

/// Of equal priorities the material that was declared first counts: the glass ends where the water begins.
TEST(NestedGlass, OfEqualPrioritiesTheFirstHides) { expect_border({.priority = 0}, {.priority = 0, .bottom = -0.5f}, 0, true); }

/// Where two faces are the same plane there is one interface, in either order of the objects, and even where their diagonals coincide.
struct Touching {
    bool water_first, same_size;
};
class TouchingGlass : public testing::TestWithParam<Touching> {};

TEST_P(TouchingGlass, HasOneInterfaceWhereFacesCoincide) {
    const auto [water_first, same_size] = GetParam();
    expect_border({.priority = 0, .half_width = same_size ? 8.0f : 9.0f}, {.priority = 0, .bottom = 0}, 0, !water_first);
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
        const uint clear = add_clear(scene, 1.5f, 0), floor = add_material(scene, emitter(Spectrum(2)));
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

/// A material that a file of meshes has brought along is named as the scene names it, and is no other than the scene's own. A ball
/// in the glass shows whether the eye is in it too.
TEST(NestedGlass, TheEyeMayBeInTheGlassOfAMeshFile) {
    const MeshFolder folder;
    folder.write("box.mtl", "newmtl clear\nKd 0 0 0\nNi 1.5\nillum 7\n");
    folder.write("box.obj",
                 "mtllib box.mtl\nusemtl clear\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
                 "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n");
    const auto hash = [&](const std::string &inside, const std::string &material) {
        const std::string file = folder.write(
            "scene.json",
            R"({"film": {"width": 24, "height": 24}, "background": [0.3, 0.5, 0.9], "camera": {"from": [0, 0, 0.5], "at": [0.2, 0.1, -1], )" +
                inside + R"("fov": 90}, "materials": [{"name": "lamp", "type": "whitted", "diffuse": 0, "emission": [1, 2, 3]},
{"name": "own", "type": "whitted", "diffuse": 0, "reflection": 1, "transmission": 1, "fresnel": true, "eta": 1.5, "exponent": 50},
{"name": "ball", "type": "whitted", "diffuse": 0, "transmission": 1, "fresnel": true, "eta": 2, "priority": 1}],
"objects": [{"type": "sphere", "material": "lamp", "center": [0, 0, -4], "radius": 1},
{"type": "sphere", "material": "ball", "center": [0.1, 0, -0.3], "radius": 0.3}, {"type": "mesh", )" +
                material + R"("file": "box.obj"}]})");
        return film_hash(render_scene(read_scene(file)).film);
    };
    const std::uint64_t own = hash(R"("inside": ["own"], )", R"("material": "own", )");
    EXPECT_EQ(hash(R"("inside": ["box.obj:clear"], )", ""), own);
    EXPECT_NE(hash("", ""), own) << "the eye is in it";
    try {
        hash(R"("inside": ["box.obj:clear"], )", R"("material": "own", )");
        FAIL() << "nothing has it";
    } catch (const SceneError &error) {
        EXPECT_NE(std::string(error.what()).find("/camera/inside: there is no material \"box.obj:clear\"; transparent: own, ball"), std::string::npos)
            << error.what();
    }
}
