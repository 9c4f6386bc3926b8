/// Light of emissive shapes in instances against irradiances that do not know of any.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "scene/compile.h"
#include "scene/lights/light.h"
#include "scene/primitives/add.h"
#include "tests/images/irradiance.h"

namespace {

using namespace brandung;
using namespace irradiance;

/// Makes what was added to the world a group, which is seen where the maps place it.
void place(Scene &scene, std::initializer_list<AffineMap> maps, uint material = NO_MATERIAL) {
    const uint group = add_group(scene, "lamps", std::exchange(scene.shapes, {}));
    for (const AffineMap &map : maps) ASSERT_FALSE(add_instance(scene, group, map, material));
}

/// That of the first map, then of the others.
AffineMap chain(std::initializer_list<AffineMap> maps) {
    AffineMap all;
    for (const AffineMap &map : maps) all = then(all, map);
    return all;
}

/// A parallelogram of the group's space that a map makes the square [-1, 1]² at height 2.
struct Placing {
    const char *name;
    vec3 corner, u, v;
    AffineMap map;
    float x = 0;  ///< to where everything is moved
};

std::ostream &operator<<(std::ostream &out, const Placing &placing) { return out << placing.name; }

/// What a map makes the square, moved along x.
Placing placed_by(const char *name, const AffineMap &map, float x = 0) {
    const auto place_of = [&](glm::dvec3 p) { return glm::inverse(map.linear) * (p + glm::dvec3(x, 0, 0) - map.offset); };
    const glm::dvec3 corner = place_of({-1, 2, -1});
    return {name, vec3(corner), vec3(place_of({1, 2, -1}) - corner), vec3(place_of({-1, 2, 1}) - corner), map, x};
}

class PlacedSquare : public testing::TestWithParam<Placing> {};

TEST_P(PlacedSquare, GivesItsFormFactor) {
    const vec3 seen(0.8f + GetParam().x, 0, -0.3f);
    Scene scene = scene_seen_at(seen + vec3(4, 1, 0.5f), seen);
    add_quad(scene, 1, GetParam().corner, GetParam().u, GetParam().v);
    place(scene, {GetParam().map});
    add_quad(scene, 0, {GetParam().x - 50, 0, 50}, {100, 0, 0}, {0, 0, -100});
    const Estimate placed = estimate(scene);
    expect_mean(placed, square_factor(0.8f, -0.3f));
    EXPECT_EQ(placed.shadow_hits, 0u) << "a lamp does not shadow itself";
    EXPECT_EQ(placed.shadow_rays, placed.samples);
}

/// The last ones: from so far away that rounding moves the square and the rays to it by some thousandths; by a shear that stretches by a thousand,
/// along the square, where it does not matter; nearly flat across the square; with a way into the group's space that is a difference of numbers of
/// 1e5, where it does matter.
INSTANTIATE_TEST_SUITE_P(EmissiveInstances, PlacedSquare,
                         testing::Values(placed_by("Moved", translation({-1000, 7, -4})), placed_by("Turned", rotation(90, {1, 0, 0})),
                                         placed_by("Mirrored", scaling({-1, 1, 1})), placed_by("Stretched", scaling({0.1, 1, 10})),
                                         placed_by("Small", scaling(glm::dvec3(1e-3))), placed_by("Large", scaling(glm::dvec3(1e3))),
                                         placed_by("Sheared", {{{1, 0, 0}, {0, 1, 0}, {1, 0, 1}}, {0, 0, 0}}),
                                         placed_by("Tilted", {{{1, -1, 0}, {0, 1, 0}, {0, -1, 1}}, {0, -3, 0}}),
                                         placed_by("Far", chain({translation({7e3, 8e3, -6e3}), rotation(37, {1, 2, -1}), scaling({1, 1.5, 0.7})})),
                                         placed_by("ShearedFar", {{{1, 0, 0}, {1000, 1, 0}, {0, 0, 1}}, {0, 0, 0}}),
                                         placed_by("Pressed", scaling({1, 1e-4, 1})),
                                         placed_by("Cancelled", {{{0.007, 0.7, 0}, {0.0037, -0.9, 0}, {0, 0, 1}}, {1000.1, 0, 0}}, 1000)),
                         [](const auto &info) { return info.param.name; });

/// Of the unit sphere as a map makes it: over its points w, with the area that the map's derivatives make of dz dphi.
Real ellipsoid_factor(const glm::dmat3 &linear, const glm::dvec3 &center) {
    using V = glm::vec<3, Real>;
    const glm::mat<3, 3, Real> m(linear);
    constexpr int rings = 400, spokes = 800;
    Real sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < spokes; ++j) {
            const Real z = -1 + 2 * (i + 0.5L) / rings, phi = 2 * pi * (j + 0.5L) / spokes, r = std::sqrt(1 - z * z);
            const V w(r * std::cos(phi), r * std::sin(phi), z), by_z(-z / r * std::cos(phi), -z / r * std::sin(phi), 1), by_phi(-w.y, w.x, 0);
            const V q = m * w + V(center), area = glm::cross(m * by_phi, m * by_z);
            const Real square = glm::dot(q, q), facing = -glm::dot(area, q);
            if (facing > 0) sum += facing * q.y / (square * square);
        }
    return sum * (2.0L / rings) * (2 * pi / spokes) / pi;
}

class PlacedBall : public testing::TestWithParam<double> {};

/// Stretched, turned and mirrored, above the horizon.
TEST_P(PlacedBall, GivesWhatItsMapMakesOfIt) {
    const double stretch = GetParam();
    const AffineMap map = chain({scaling({stretch, -0.5, 0.8}), rotation(37, {1, 2, -1}), translation({1, 2.5, -2})});
    Scene scene = scene_seen_at({4, 1, 0.5f}, {0, 0, 0});
    scene.film.spp = 64;
    add_sphere(scene, 1, {0, 0, 0}, 1);
    place(scene, {map});
    add_floor(scene);
    const Real expected = ellipsoid_factor(map.linear, map.offset);
    const Estimate once = estimate(scene);
    expect_mean(once, expected);
    EXPECT_EQ(once.shadow_hits, 0u) << "only what is seen of the lamp is asked";
    EXPECT_EQ(once.shadow_rays, once.samples);
    scene.integrator.light_samples = 3;
    expect_mean(estimate(scene), expected);
}

INSTANTIATE_TEST_SUITE_P(EmissiveInstances, PlacedBall, testing::Values(0.05, 0.5, 1.5),
                         [](const auto &info) { return "Stretch" + std::to_string(info.index); });

/// A cylinder that is no longer round until its map makes it so: the middle of its floor sees the wall, and the opening above.
TEST(EmissiveInstances, WallsKeepTheirRadiance) {
    Scene scene = scene_seen_at({0.1f, 0.6f, 0.15f}, {0, 0, 0});
    add_frustum(scene, 1, {0, 0, 0}, 2, {0, 0.5f, 0}, 2);
    place(scene, {scaling({0.5, 3, 0.5})});
    add_floor(scene);
    const Estimate wall = estimate(scene);
    expect_mean(wall, 1 - 1 / 3.25L);
    EXPECT_EQ(wall.shadow_hits, 0u);
}

/// Three instances, the last of another material, and a lamp of the world: their irradiances add up, their faces are in memory once.
TEST(EmissiveInstances, AddUp) {
    Scene scene = scene_seen_at({4, 1, 0.5f}, {0, 0, 0});
    scene.film.spp = 32;
    const uint brighter = add_material(scene, emitter(Spectrum(3)));
    add_quad(scene, 1, {-0.5f, 2, -0.5f}, {1, 0, 0}, {0, 0, 1});
    place(scene, {translation({-0.5, 0, -0.5}), translation({0.5, 0, -0.5})});
    ASSERT_FALSE(add_instance(scene, 0, translation({-0.5, 0, 0.5}), brighter));
    add_floor(scene), add_quad(scene, 1, {0, 2, 0}, {1, 0, 0}, {0, 0, 1});
    expect_mean(estimate(scene), square_factor(0, 0) * 6 / 4);
    EXPECT_EQ(compile(scene).header.emissive_faces.count, 2u);
}

/// What spot and point lights have where emissive shapes have the number of their instance is no such number. These lie behind the floor.
TEST(EmissiveInstances, ShineBesideLightsOfOtherKinds) {
    Scene scene = scene_seen_at({4, 1, 0.5f}, {0, 0, 0});
    add_quad(scene, 1, {-1, 2, -1}, {2, 0, 0}, {0, 0, 2});
    place(scene, {AffineMap()});
    add_floor(scene);
    scene.lights.push_back(spot_light({0, -3, 3}, {0, 0, 0}, {15.9f, 14, 2}, 60, 0.2));
    scene.lights.push_back(make_light(PointLight{{0, -3, 0}, Spectrum(3), {1, 0, 0}}));
    const Estimate lamp = estimate(scene);
    expect_mean(lamp, square_factor(0, 0));
    EXPECT_EQ(lamp.shadow_rays, lamp.samples);
}

}  // namespace
