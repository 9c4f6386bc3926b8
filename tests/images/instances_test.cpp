/// Renders of instances: what they are made of, and that what leaves them does not meet its own place again.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "scene/bsdfs/bsdf.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace {

using namespace brandung;

constexpr uint red = 0, green = 1, clear = 2, window = 3, looking_glass = 4;  ///< materials of all scenes here

Material ambient(Spectrum reflectance) { return make_material(Whitted{.ambient = reflectance, .exponent = 1}); }

/// All scenes have the same kinds of things, out of sight where they don't need them, so that they share their programs.
Scene scene_of(vec3 from, vec3 at, float degrees) {
    Scene scene;
    scene.file = "instances";
    scene.cameras.push_back({.name = "camera", .from = from, .at = at, .fov = glm::radians(degrees)});
    scene.film.width = 32, scene.film.height = 24;
    scene.ambient = Spectrum(1);
    add_material(scene, ambient({1, 0, 0})), add_material(scene, ambient({0, 1, 0}));
    add_material(scene, glass(1.5f));
    Material between_equal_media = make_material(Whitted{.transmission = Spectrum(1), .exponent = 1});
    between_equal_media.eta = 1;
    add_material(scene, between_equal_media), add_material(scene, mirror(1));
    const vec3 away(0, 1e6f, 0);
    for (uint material = 0; material < scene.materials.size(); ++material) add_sphere(scene, material, away, 1);
    add_triangle(scene, red, away, away + vec3(1, 0, 0), away + vec3(0, 1, 0));
    scene.lights.push_back(point_light({3, 5, 4}, Spectrum(0)));
    return scene;
}

/// A ball of `own` material, once so and once made of `other`, left and right.
Scene two_balls(uint own, uint other) {
    Scene scene = scene_of({0, 0, 10}, {0, 0, 0}, 30);
    auto world = std::exchange(scene.shapes, {});
    add_sphere(scene, own, {0, 0, 0}, 1.5f);
    const uint group = add_group(scene, "ball", std::exchange(scene.shapes, std::move(world)));
    EXPECT_FALSE(add_instance(scene, group, {glm::dmat3(1), {-1.6, 0, 0}}));
    EXPECT_FALSE(add_instance(scene, group, {glm::dmat3(1), {1.6, 0, 0}}, other));
    return scene;
}

}  // namespace

TEST(Instances, AreMadeOfTheirMaterialNotOfTheGroups) {
    const Scene scene = two_balls(red, green);
    const std::vector<vec3> picture = render_scene(scene).picture;
    uint left = 0, right = 0;
    for (uint y = 0; y < 24; ++y)
        for (uint x = 0; x < 32; ++x) {
            const vec3 pixel = picture[y * 32 + x];
            if (pixel == vec3(0)) continue;
            ++(x < 16 ? left : right);
            ASSERT_EQ(pixel, x < 16 ? vec3(1, 0, 0) : vec3(0, 1, 0)) << x << ", " << y;
        }
    // 24 pixels are 2 tan 15° 10 = 5.36 high: a ball has a radius of 6.7, and 142 of them; a little more, as it is seen from near.
    EXPECT_NEAR(left, 145, 8);
    EXPECT_EQ(right, left);
}

/// To the last bit: what a ray meets, enters and leaves is the instance's material too.
TEST(Instances, OfGlassAreWhatGroupsOfGlassAre) {
    const auto film_of = [](uint own, uint other) {
        Scene scene = two_balls(own, other);
        scene.instances.erase(scene.instances.begin());  // which is of the group's own
        scene.background = {0.25f, 0.5f, 1};
        scene.cameras[0].from = {3, 1, 9};
        scene.lights[0] = point_light({3, 5, 4}, Spectrum(50));
        return film_hash(render_scene(scene).film);
    };
    const auto of_glass = film_of(clear, NO_MATERIAL), of_red = film_of(red, NO_MATERIAL);
    EXPECT_EQ(film_of(red, clear), of_glass);
    EXPECT_EQ(film_of(clear, red), of_red);
    EXPECT_NE(of_glass, of_red);
}

/// A slanted plane under an eye that is 1e-7 above it and looks along it, so narrowly that rounding decides at what slopes, of about 2^-24, rays go:
/// half of them meet the plane. Of those that leave it rounding leads some back into it, far beyond the error of their origin. They don't meet it: it
/// is one triangle, and what leaves that is known.
TEST(Instances, RaysThatLeaveAFlatPrimitiveAtAnyAngleDoNotMeetItAgain) {
    const glm::dvec3 along = glm::normalize(glm::dvec3(1, 2, 3)), normal = glm::normalize(glm::cross(along, glm::dvec3(0.3, -1, 0.2)));
    const glm::dvec3 across = glm::cross(normal, along);
    for (const bool through : {false, true}) {
        Scene scene = scene_of(vec3(1e-7 * normal), vec3(1e4 * along), 1e-5f);
        scene.cameras[0].up = vec3(normal);
        scene.background = Spectrum(1);
        scene.integrator.max_depth = 2;
        auto world = std::exchange(scene.shapes, {});
        add_triangle(scene, through ? window : looking_glass, {-1e5f, -1e5f, 0}, {1e5f, -1e5f, 0}, {0, 2e5f, 0});
        const uint group = add_group(scene, "plane", std::exchange(scene.shapes, std::move(world)));
        const AffineMap slanted = {glm::dmat3(along, across, -normal), glm::dvec3(0)};
        ASSERT_FALSE(add_instance(scene, group, slanted));
        const Rendering rendering = render_scene(scene);
        EXPECT_GT(rendering.counts.hits[RAY_CAMERA], 100u);
        EXPECT_EQ(rendering.counts.rays[through ? RAY_REFRACTED : RAY_REFLECTED], rendering.counts.hits[RAY_CAMERA]);
        EXPECT_EQ(rendering.counts.hits[through ? RAY_REFRACTED : RAY_REFLECTED], 0u);
    }
}
