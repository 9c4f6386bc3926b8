/// Light of emissive surfaces against analytic irradiances.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/images/irradiance.h"

namespace {

using namespace brandung;
using namespace irradiance;

/// The same quadrilateral as 2 n² triangles, which make n² parallelograms.
void add_grid(Scene &scene, uint material, vec3 corner, vec3 u, vec3 v, uint n) {
    MeshData mesh;
    for (uint j = 0; j <= n; ++j)
        for (uint i = 0; i <= n; ++i) mesh.positions.push_back(corner + u * (float(i) / float(n)) + v * (float(j) / float(n)));
    for (uint j = 0; j < n; ++j)
        for (uint i = 0; i < n; ++i) {
            const uint a = j * (n + 1) + i, b = a + n + 1;
            for (const uint index : {a, a + 1, b + 1, a, b + 1, b}) mesh.indices.push_back(index);
        }
    add_triangle_mesh(scene, material, std::move(mesh));
}

class Square : public testing::TestWithParam<vec2> {
protected:
    const vec3 place{GetParam().x, 0, GetParam().y};
    Scene scene = scene_seen_at(place + vec3(4, 1, 0.5f), place);
    const Real expected = square_factor(place.x, place.z);
};

}  // namespace

TEST_P(Square, GivesItsFormFactorTimesPiOverPi) {
    add_floor(scene), add_quad(scene, 1, {-1, 2, -1}, {2, 0, 0}, {0, 0, 2});
    const Estimate once = estimate(scene);
    expect_mean(once, expected);
    EXPECT_EQ(once.shadow_hits, 0u) << "a lamp does not shadow itself";
    EXPECT_EQ(once.shadow_rays, once.samples);

    // A quad is one face: each of 4 x 4 strata is a part of it.
    scene.integrator.light_samples = 4;
    const Estimate strata = estimate(scene);
    expect_mean(strata, expected);
    EXPECT_EQ(strata.shadow_rays, 16 * strata.samples);
    EXPECT_EQ(strata.shadow_hits, 0u);
    // 16 for the number; of a parabola over the square, as light falls below its middle, strata of a quarter leave (5 / 192) / (4 / 45) = 1 / 3.4 of
    // the variance, of a slope 1 / 16.
    EXPECT_LT(strata.variance, once.variance / 50);
}

TEST_P(Square, IsTheSameInManyTriangles) {
    add_floor(scene), add_grid(scene, 1, {-1, 2, -1}, {2, 0, 0}, {0, 0, 2}, 10);
    const Estimate grid = estimate(scene);
    expect_mean(grid, expected);
    EXPECT_EQ(grid.shadow_hits, 0u);

    // Cells are of several faces each, and nearly as compact as those of one; points of faces chosen at random would leave a 16th.
    scene.integrator.light_samples = 4;
    const Estimate cells = estimate(scene);
    expect_mean(cells, expected);
    EXPECT_LT(cells.variance, grid.variance / 30);
}

TEST_P(Square, ShinesOnBothSides) {
    add_floor(scene), add_quad(scene, 1, {-1, 2, 1}, {2, 0, 0}, {0, 0, -2});
    expect_mean(estimate(scene), expected);
}

INSTANTIATE_TEST_SUITE_P(EmissiveLights, Square, testing::Values(vec2(0, 0), vec2(0.8f, -0.3f), vec2(-3, 2)),
                         [](const auto &info) { return "Place" + std::to_string(info.index); });

/// Two triangles that make no parallelogram: halves of unequal area, of which each is chosen by its own.
TEST(EmissiveLights, TrianglesAreChosenByArea) {
    Scene scene = scene_seen_at({4, 1, 0.5f}, {0, 0, 0});
    add_floor(scene);
    MeshData mesh{.positions = {{-1, 2, -1}, {1, 2, -1}, {1, 2, 1}, {-1, 2, 1}, {-1, 2, -0.5f}}, .indices = {0, 1, 4, 4, 1, 2, 4, 2, 3}};
    add_triangle_mesh(scene, 1, std::move(mesh));
    expect_mean(estimate(scene), square_factor(0, 0));
}

class Ball : public testing::TestWithParam<float> {};

/// A sphere of radius r at distance d, all of it above the horizon: E = pi L (r / d)² cos.
TEST_P(Ball, GivesTheSquaredRatioTimesTheCosine) {
    const float radius = GetParam();
    Scene scene = scene_seen_at({4, 1, 0.5f}, {0, 0, 0});
    scene.film.spp = 32;  // near the lamp one sample's deviation is 1.2 times the mean
    add_floor(scene), add_sphere(scene, 1, {1, 2, -2}, radius);
    const Real expected = Real(radius) * radius / 9 * 2 / 3;  // d = 3, cosine 2 / 3
    const Estimate once = estimate(scene);
    expect_mean(once, expected);
    EXPECT_EQ(once.shadow_hits, 0u) << "only what is seen of the lamp is asked";
    // z² of the chosen point, z along the axis towards the floor's, is uniform from the horizon's (r / d)² to 1: within eps of the horizon, where
    // rounding cannot tell which side of the lamp is seen, are eps / (1 - (r / d)²) of all. Not asked are points over whose tangent plane the floor's
    // is by 8e-6 or less; that height is d z - r, so that eps is 2 (r / d) 8e-6 / d: at most 6e-6 of all samples, with the largest radius.
    EXPECT_LE(once.shadow_rays, once.samples);
    EXPECT_GE(once.shadow_rays, once.samples - once.samples / 1000) << "all but those that graze it";
    scene.integrator.light_samples = 4;
    expect_mean(estimate(scene), expected);
}

INSTANTIATE_TEST_SUITE_P(EmissiveLights, Ball, testing::Values(0.01f, 0.5f, 1.9f),
                         [](const auto &info) { return "Radius" + std::to_string(info.index); });

/// From afar every point of a sphere counts nearly the same, in spite of one sample. With e = r / d = 1/300 and z² uniform, a sample's cosine at the
/// lamp over the density is 1 - e (1 - z²) / z, whose deviation is e sqrt(ln(1 / e²) - 3/2) = 1.05 %; the distance adds 2 e sd(z) = 0.16 %, the
/// cosine at the floor 0.2 %: together 1.08 %. Points uniform by area would have 71 %.
TEST(EmissiveLights, DistantSpheresAreWithoutNoise) {
    Scene scene = scene_seen_at({4, 1, 0.5f}, {0, 0, 0});
    add_floor(scene), add_sphere(scene, 1, {1, 2, -2}, 0.01f);
    const Estimate once = estimate(scene);
    EXPECT_LT(std::sqrt(once.variance), 0.0115L * once.mean);
}

/// The middle of the floor of a round room sees of its hemisphere the wall, and the opening above: 1 - b² / (b² + h²).
class Wall : public testing::TestWithParam<float> {};

TEST_P(Wall, OfConesAndCylindersGivesWhatTheOpeningLeaves) {
    const float top = GetParam();
    Scene scene = scene_seen_at({0.1f, 0.6f, 0.15f}, {0, 0, 0});
    add_floor(scene), add_frustum(scene, 1, {0, 0, 0}, 1, {0, 1.5f, 0}, top);
    const Real expected = 1 - Real(top) * top / (Real(top) * top + 2.25L);
    const Estimate once = estimate(scene);
    expect_mean(once, expected);
    EXPECT_EQ(once.shadow_hits, 0u);
    scene.integrator.light_samples = 3;
    expect_mean(estimate(scene), expected);
}

INSTANTIATE_TEST_SUITE_P(EmissiveLights, Wall, testing::Values(1.0f, 0.4f, 0.0f, 2.0f),
                         [](const auto &info) { return "Top" + std::to_string(info.index); });

/// In a sphere of radiance L and reflectance rho every point has irradiance pi L from its own wall: each of its points counts the same, since
/// cos cos' / d² = 1 / (4 r²). So every pixel is L + rho L.
TEST(EmissiveLights, FurnaceOfOneBounceHasNoNoise) {
    Scene scene = scene_seen_at({0.3f, 0.2f, -0.4f}, {-1, 0.5f, 0.7f});
    scene.cameras[0].fov = 1.2f;
    Material material = matte(0.25f);
    material.emission = Spectrum(2);
    add_sphere(scene, add_material(scene, material), {0, 0, 0}, 1);
    const Rendering rendering = render_scene(scene);
    // A point at distance d has cosine d / 2, of which rounding moves 3e-6 / d. Of 12288 points the nearest lies at about 0.01, where that is 5 % of
    // one of a pixel's 16 samples.
    for (const vec3 &pixel : rendering.picture) ASSERT_NEAR(pixel.x, 2.5f, 5e-3f);
    EXPECT_EQ(rendering.counts.hits[RAY_SHADOW], 0u);
}

/// What is convex does not light itself from outside, wherever it is: it shows what it shines, plus what it reflects of nothing.
TEST(EmissiveLights, DoNotLightThemselves) {
    for (const float far : {0.0f, 1.0f, 100.0f, 3000.0f})
        for (const char *kind : {"sphere", "frustum", "quad"}) {
            const vec3 center(far);
            Scene scene = scene_seen_at(center + vec3(1, 0, 4), center);
            scene.cameras[0].fov = 0.5f;
            Material material = matte(0.8f);
            material.emission = Spectrum(1);
            const uint lamp = add_material(scene, material);
            if (kind == std::string("sphere")) add_sphere(scene, lamp, center, 1);
            if (kind == std::string("frustum")) add_frustum(scene, lamp, center - vec3(0, 1, 0), 1, center + vec3(0, 1, 0), 0.5f);
            if (kind == std::string("quad")) add_quad(scene, lamp, center - vec3(1, 1, 0), {2, 0, 0}, {0, 2, 0});
            const Rendering rendering = render_scene(scene);
            EXPECT_EQ(rendering.clamped, 0u);
            for (const vec3 &pixel : rendering.picture) ASSERT_LE(pixel.x, 1) << kind << " at " << far;
            EXPECT_EQ(rendering.picture[rendering.picture.size() / 2 + 16].x, 1) << kind << " at " << far;
        }
}

/// Lamps are seen, but light nothing, where no light samples are asked for.
TEST(EmissiveLights, NoSamplesNoLight) {
    Scene scene = scene_seen_at({4, 1, 0.5f}, {0, 0, 0});
    scene.integrator.light_samples = 0;
    add_floor(scene), add_sphere(scene, 1, {1, 2, -2}, 1);
    const Estimate dark = estimate(scene);
    EXPECT_EQ(dark.mean, 0);
    EXPECT_EQ(dark.shadow_rays, 0u);
}

/// Half of a square lamp behind a screen: half of its rays meet something.
TEST(EmissiveLights, ShadowsHavePenumbras) {
    Scene scene = scene_seen_at({4, 0.5f, 0.5f}, {0, 0, 0});
    add_floor(scene), add_quad(scene, 1, {-1, 2, -1}, {2, 0, 0}, {0, 0, 2}), add_quad(scene, 0, {0, 1, -9}, {9, 0, 0}, {0, 0, 18});
    scene.integrator.light_samples = 2;
    const Estimate half = estimate(scene);
    expect_mean(half, square_factor(0, 0) / 2);
    // Two of the four strata lie behind the screen; what pixels see is some thousandths wide.
    EXPECT_NEAR(2.0L * half.shadow_hits, half.shadow_rays, 0.01L * half.shadow_rays);
}
