/// Pictures whose every pixel has a value known by analysis.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/bsdfs/bsdf.h"
#include "scene/lights/light.h"
#include "tests/images/oracle.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace {

using namespace brandung;
using oracle::Real;
using oracle::Vec;

Scene scene_seen_from(vec3 from, vec3 at, uint width = 32, uint height = 24) {
    Scene scene;
    scene.file = "furnace";
    CameraDescription camera;
    camera.from = from, camera.at = at, camera.fov = glm::radians(60.0f);
    camera.up = std::abs(glm::normalize(at - from).y) > 0.9f ? vec3(0, 0, 1) : vec3(0, 1, 0);
    scene.cameras.push_back(camera);
    scene.film.width = width, scene.film.height = height;
    return scene;
}

/// Expects `radiance(x, y)` of every pixel, within a relative error of `tolerance` and the film's resolution.
template <class Radiance> void expect_picture(const Scene &scene, Real tolerance, Radiance radiance) {
    const Rendering rendering = render_scene(scene);
    EXPECT_EQ(rendering.refused, 0u);
    EXPECT_EQ(rendering.clamped, 0u);
    for (uint y = 0; y < scene.film.height; ++y)
        for (uint x = 0; x < scene.film.width; ++x) {
            const vec3 value = rendering.picture[y * scene.film.width + x];
            const Vec expected = radiance(x, y);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(value[c], expected[c], tolerance * expected[c] + 0x1p-30L) << "pixel " << x << ", " << y << ", colour " << c;
        }
}

void expect_uniform(const Scene &scene, Real tolerance, Spectrum radiance) {
    expect_picture(scene, tolerance, [&](uint, uint) { return Vec(radiance); });
}

uint add_whitted(Scene &scene, const Whitted &whitted, Spectrum emission = Spectrum(0)) {
    Material material = make_material(whitted);
    material.emission = emission;
    return add_material(scene, material);
}

/// A square of side 2 * half in the plane y = height, seen from above as its outside.
void add_floor(Scene &scene, uint material, float half, float height = 0) {
    MeshData mesh;
    append_polygon(scene, mesh, {{-half, height, half}, {half, height, half}, {half, height, -half}, {-half, height, -half}}, {});
    add_triangle_mesh(scene, material, std::move(mesh));
}

/// The six sides of the cube [-half, half]³, outsides outside.
void add_cube(Scene &scene, uint material, float half) {
    MeshData mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-half, half}) {
            const auto corner = [&](float u, float v) {
                vec3 p;
                p[axis] = side, p[(axis + 1) % 3] = side > 0 ? u : v, p[(axis + 2) % 3] = side > 0 ? v : u;
                return p;
            };
            append_polygon(scene, mesh, {corner(-half, -half), corner(half, -half), corner(half, half), corner(-half, half)}, {});
        }
    add_triangle_mesh(scene, material, std::move(mesh));
}

}  // namespace

// ---- lights on matte surfaces ----------------------------------------------------------------------------------------------------------------

/// Irradiance π cos 0 / 1², reflectance 1/2: radiance π (1/2) / π. Nothing is mirrored, so depth changes nothing.
TEST(Furnace, SphereAroundAPointLightIsEvenlyBrightAtEveryDepth) {
    for (const uint depth : {1u, 2u, 5u, 20u}) {
        Scene scene = scene_seen_from({0.3f, 0.2f, -0.4f}, {-1, 0.5f, 0.7f});
        scene.integrator.max_depth = depth;
        add_sphere(scene, add_material(scene, matte(0.5f)), {0, 0, 0}, 1);
        scene.lights.push_back(point_light({0, 0, 0}, Spectrum(oracle::pi)));
        // The light's distance is that of a point moved sqrt(3) 2^-21 off the surface, and enters squared.
        expect_uniform(scene, 3e-6L, Spectrum(0.5f));
    }
}

/// With a sphere of radius 10 and a light of 100 π the same, also for a frustum's inside and from far off the origin.
TEST(Furnace, NeitherSizeNorPlaceChangesTheBrightness) {
    Scene scene = scene_seen_from({1003, 1002, 996}, {990, 1005, 1007});
    add_sphere(scene, add_material(scene, matte(0.5f)), {1000, 1000, 1000}, 10);
    scene.lights.push_back(point_light({1000, 1000, 1000}, Spectrum(100 * oracle::pi)));
    // The point's error, 2^-21 (1000 + 10), is of the radius 5e-5, and twice that in the square.
    expect_uniform(scene, 2e-4L, Spectrum(0.5f));
}

TEST(Furnace, EmissionAndAmbientLightAreExact) {
    Scene scene = scene_seen_from({0, 0, 0}, {1, 0.3f, 0.2f});
    scene.ambient = Spectrum(0.5f, 0.25f, 1);
    add_sphere(scene, add_whitted(scene, Whitted{.ambient = Spectrum(0.5f, 1, 0.125f), .exponent = 1}, Spectrum(0.25f, 2, 0)), {0, 0, 0}, 1);
    expect_uniform(scene, 0, Spectrum(0.5f, 2.25f, 0.125f));  // 1/4 + 1/2 1/2, 2 + 1/4 1, 0 + 1 1/8
}

TEST(Furnace, MissesShowTheBackgroundExactly) {
    Scene scene = scene_seen_from({0, 0, 0}, {1, 0, 0});
    scene.background = Spectrum(0.1f, 0.2f, 7);
    add_sphere(scene, add_material(scene, matte(0.5f)), {-5, 0, 0}, 1);
    expect_uniform(scene, 0x1p-23L, Spectrum(0.1f, 0.2f, 7));
}

namespace {

/// A floor with reflectance (0.5, 0.25, 0.125) under one light, seen from above at a slant.
Scene lit_floor(const Light &light) {
    Scene scene = scene_seen_from({1, 3, 2}, {0, 0, 0});
    scene.cameras[0].fov = glm::radians(40.0f);
    const Spectrum reflectance(0.5f, 0.25f, 0.125f);
    add_floor(scene, add_whitted(scene, Whitted{.ambient = reflectance, .diffuse = reflectance, .exponent = 1}), 8);
    scene.lights.push_back(light);
    return scene;
}

/// Where pixel (x, y) of such a scene sees the floor.
Vec floor_point(const Scene &scene, uint x, uint y) {
    const oracle::Line ray = oracle::eye_ray(scene, x, y);
    return ray.at(oracle::cross_plane(ray, Vec(0), Vec(0, 1, 0)));
}

}  // namespace

class Attenuation : public testing::TestWithParam<vec3> {};

TEST_P(Attenuation, DividesByConstantLinearAndQuadraticTerm) {
    const vec3 position(-0.5f, 1.5f, 0.75f), terms = GetParam();
    const Spectrum intensity(3, 5, 7);
    const Scene scene = lit_floor(make_light(PointLight{position, intensity, terms}));
    // Shadow rays begin up to 8 2^-21 above the floor, which counts most for the lowest way to the light, 1.5.
    expect_picture(scene, 6e-6L, [&](uint x, uint y) {
        const Vec way = Vec(position) - floor_point(scene, x, y);
        const Real d = glm::length(way), cosine = way.y / d;
        return Vec(0.5L, 0.25L, 0.125L) * Vec(intensity) * (cosine / oracle::pi / (terms.x + terms.y * d + terms.z * d * d));
    });
}

INSTANTIATE_TEST_SUITE_P(Furnace, Attenuation, testing::Values(vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(0.5f, 0.25f, 2)),
                         [](const auto &info) { return "Terms" + std::to_string(info.index); });

/// From 3 above the floor, aimed straight down: full up to 10° around the axis, nothing from 20° on, and between them s² (3 - 2 s), s running with
/// the cosine. Where there is no light, no shadow ray is sent.
TEST(Furnace, SpotLightFallsFromItsConeToTheEdge) {
    const vec3 position(0, 3, 0);
    const Real edge = std::cos(oracle::pi / 9), full = std::cos(oracle::pi / 18);
    Scene scene = lit_floor(spot_light(position, {0, 0, 0}, Spectrum(3, 5, 7), 40, 0.5));
    scene.cameras[0].fov = glm::radians(60.0f);
    std::size_t inside = 0, between = 0, outside = 0;
    const Rendering rendering = render_scene(scene);
    for (uint y = 0; y < scene.film.height; ++y)
        for (uint x = 0; x < scene.film.width; ++x) {
            const Vec way = Vec(position) - floor_point(scene, x, y);
            const Real d = glm::length(way), cosine = way.y / d, s = std::clamp((cosine - edge) / (full - edge), Real(0), Real(1));
            (s == 0 ? outside : s == 1 ? inside : between) += 1;
            const Vec expected = Vec(0.5L, 0.25L, 0.125L) * Vec(3, 5, 7) * (s * s * (3 - 2 * s) * cosine / oracle::pi / (d * d));
            // The cosine's error, 1e-7, is in s 1 / (full - edge) = 22 times as large.
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(rendering.picture[y * scene.film.width + x][c], expected[c], s == 0 ? 0x1p-33L : 1e-6L + 6e-6L * expected[c])
                    << "pixel " << x << ", " << y;
        }
    EXPECT_GT(inside, 15u);
    EXPECT_GT(between, 50u);
    EXPECT_GT(outside, 50u);
    EXPECT_EQ(rendering.counts.rays[RAY_SHADOW], inside + between);
}

TEST(Furnace, DirectionalLightFallsByTheCosineAtAnyDistance) {
    const vec3 towards(1, 2, -2);
    const Scene scene = lit_floor(directional_light(towards, Spectrum(oracle::pi)));
    expect_uniform(scene, 1e-6L, Spectrum(0.5f, 0.25f, 0.125f) * (2.0f / 3));  // cosine 2 / |(1, 2, -2)|
}

TEST(Furnace, LightFromBehindAnOpaqueSurfaceIsNotSeen) {
    expect_uniform(lit_floor(directional_light({0.2f, -1, 0.1f}, Spectrum(1))), 0, Spectrum(0));
    expect_uniform(lit_floor(point_light({0, -1, 0}, Spectrum(1))), 0, Spectrum(0));
}

TEST(Furnace, LightsAddUp) {
    Scene scene = lit_floor(directional_light({0, 1, 0}, Spectrum(oracle::pi)));
    for (int i = 0; i < 19; ++i) scene.lights.push_back(directional_light({0, 1, 0}, Spectrum(oracle::pi)));
    expect_uniform(scene, 1e-6L, 20.0f * Spectrum(0.5f, 0.25f, 0.125f));
}

/// Irradiance falls off a ball as the cosine, and the terminator is where the formula has it; nothing is in the way of its own light.
TEST(Furnace, BallInDirectionalLightFollowsTheCosine) {
    Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0}, 64, 64);
    add_sphere(scene, add_material(scene, matte(1)), {0, 0, 0}, 1);
    const Vec towards = glm::normalize(Vec(2, 1, 0.5L));
    scene.lights.push_back(directional_light(vec3(towards), Spectrum(oracle::pi)));
    const Rendering rendering = render_scene(scene);
    for (uint y = 0; y < 64; ++y)
        for (uint x = 0; x < 64; ++x) {
            const oracle::Line ray = oracle::eye_ray(scene, x, y);
            const auto crossings = oracle::cross_sphere(ray, Vec(0), 1);
            const Real cosine = crossings ? std::max(0.0L, glm::dot(ray.at(crossings->first), towards)) : 0;
            // A ray that grazes the ball meets it where rounding, 1e-7, has moved it by the root of that.
            const Real chord = crossings ? crossings->second - crossings->first : 1;
            ASSERT_NEAR(rendering.picture[y * 64 + x].x, cosine, 2e-6L / chord) << x << ", " << y;
        }
}

// ---- highlights ------------------------------------------------------------------------------------------------------------------------------

class Highlight : public testing::TestWithParam<float> {};

/// (V·R)^n / π of the irradiance, at every pixel.
TEST_P(Highlight, IsThePowerOfTheCosineToTheMirrorDirection) {
    const float exponent = GetParam();
    Scene scene = lit_floor(make_light(PointLight{vec3(-1, 3, -2), Spectrum(oracle::pi), vec3(1, 0, 0)}));  // mirrored in the middle of the picture
    scene.materials[0].record = make_material(Whitted{.specular = Spectrum(0.5f, 1, 2), .exponent = exponent});
    const Rendering rendering = render_scene(scene);
    std::size_t bright = 0;
    for (uint y = 0; y < scene.film.height; ++y)
        for (uint x = 0; x < scene.film.width; ++x) {
            const Vec p = floor_point(scene, x, y), light = glm::normalize(Vec(-1, 3, -2) - p), eye = glm::normalize(Vec(1, 3, 2) - p);
            const Real mirrored = std::max(0.0L, glm::dot(-oracle::reflect(light, Vec(0, 1, 0)), eye)), expected = std::pow(mirrored, Real(exponent));
            bright += mirrored > 0.99L;
            // V·R is off by some 1e-6, which the exponent multiplies.
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(rendering.picture[y * scene.film.width + x][c], Vec(0.5L, 1, 2)[c] * expected, 1e-6L + 2e-6L * exponent * expected)
                    << x << ", " << y;
        }
    EXPECT_GT(bright, 10u) << "the highlight is in the picture";
}

INSTANTIATE_TEST_SUITE_P(Furnace, Highlight, testing::Values(1.0f, 2.5f, 50.0f, 1000.0f),
                         [](const auto &info) { return "Exponent" + std::to_string(static_cast<int>(info.param)); });

/// Where N·L <= 0 there is no highlight, even where V·R > 0.
TEST(Furnace, NoHighlightWhereTheSurfaceIsTurnedAway) {
    Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0}, 64, 64);
    add_sphere(scene, add_whitted(scene, Whitted{.specular = Spectrum(1), .exponent = 1}), {0, 0, 0}, 1);
    const Vec towards = glm::normalize(Vec(1, 0, -0.5L));
    scene.lights.push_back(directional_light(vec3(towards), Spectrum(oracle::pi)));
    const Rendering rendering = render_scene(scene);
    std::size_t would_be_bright = 0;
    for (uint y = 0; y < 64; ++y)
        for (uint x = 0; x < 64; ++x) {
            const oracle::Line ray = oracle::eye_ray(scene, x, y);
            const auto crossings = oracle::cross_sphere(ray, Vec(0), 1);
            if (!crossings) continue;
            const Vec normal = ray.at(crossings->first);
            if (glm::dot(normal, towards) > -0.01L) continue;
            ASSERT_EQ(rendering.picture[y * 64 + x].x, 0) << x << ", " << y;
            would_be_bright += glm::dot(-oracle::reflect(towards, normal), -ray.direction) > 0.1L;
        }
    EXPECT_GT(would_be_bright, 20u);
}

// ---- mirrors ---------------------------------------------------------------------------------------------------------------------------------

/// Emission 1/2, reflectance 1/2: 1/2 + 1/4 + ... = 1 - 2^-depth, without any rounding.
TEST(Furnace, MirrorBoxSumsAGeometricSeriesExactly) {
    for (const uint depth : {1u, 2u, 3u, 5u, 10u, 20u}) {
        Scene scene = scene_seen_from({0.1f, 0.2f, 0.3f}, {1, -0.2f, 0.5f});
        scene.integrator.max_depth = depth;
        add_cube(scene, add_whitted(scene, Whitted{.reflection = Spectrum(0.5f), .exponent = 1}, Spectrum(0.5f)), 1);
        expect_uniform(scene, 0, Spectrum(1 - std::exp2(-static_cast<float>(depth))));
    }
}

TEST(Furnace, MirrorsHaveColour) {
    Scene scene = scene_seen_from({0.1f, 0.2f, 0.3f}, {1, -0.2f, 0.5f});
    scene.integrator.max_depth = 4;
    add_cube(scene, add_whitted(scene, Whitted{.reflection = Spectrum(0.5f, 0.25f, 0), .exponent = 1}, Spectrum(1)), 1);
    expect_uniform(scene, 0, Spectrum(1.875f, 1 + 0.25f + 0.0625f + 0.015625f, 1));
}

TEST(Furnace, RaysBelowTheThresholdAreNotTraced) {
    Scene scene = scene_seen_from({0.1f, 0.2f, 0.3f}, {1, -0.2f, 0.5f});
    scene.integrator.max_depth = 20;
    scene.integrator.threshold = 0.125f;  // weights 1, 1/2, 1/4, 1/8 are traced, 1/16 is not
    add_cube(scene, add_whitted(scene, Whitted{.reflection = Spectrum(0.5f), .exponent = 1}, Spectrum(0.5f)), 1);
    expect_uniform(scene, 0, Spectrum(1 - 0x1p-4f));
}

/// A mirror on the floor shows the background above, times its weight.
TEST(Furnace, MirrorShowsWhatIsAbove) {
    Scene scene = scene_seen_from({1, 3, 2}, {0, 0, 0});
    scene.background = Spectrum(0.5f, 1, 2);
    add_floor(scene, add_material(scene, mirror(0.75f)), 100);
    expect_uniform(scene, 0x1p-23L, 0.75f * scene.background);
}
