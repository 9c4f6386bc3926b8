/// Light of the picture all around, by integrator path, against what integration over all directions makes of it.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>

#include "scene/compile.h"
#include "tests/images/irradiance.h"

namespace {

using namespace brandung;
using namespace irradiance;

/// As background of radiance 1.
void add_panorama(Scene &scene, uint width, uint height, const std::function<Spectrum(uint, uint)> &texel) {
    std::vector<vec3> pixels;
    for (uint row = 0; row < height; ++row)
        for (uint column = 0; column < width; ++column) pixels.push_back(texel(column, row));
    scene.textures.push_back({"", {.wrap = TextureWrap::panorama}, {width, height, pixels, {}}});
    scene.background = Spectrum(1), scene.background_texture = uint(scene.textures.size());
}

/// As kernels have it, of the first channel.
Real radiance_from(const Scene &scene, Real x, Real y, Real z) {
    const Picture &picture = scene.textures.at(scene.background_texture - 1).picture;
    const int width = int(picture.width), height = int(picture.height);
    const Real u = 0.5L + std::atan2(x, -z) / (2 * pi) + Real(scene.background_turn), v = std::acos(y) / pi;
    const Real column = (u - std::floor(u)) * width - 0.5L, row = v * height - 0.5L;
    const int left = int(std::floor(column)), above = int(std::floor(row));
    Real sum = 0;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i)
            sum += (1 - std::abs(column - (left + i))) * (1 - std::abs(row - (above + j))) *
                   Real(picture.pixels[std::size_t(std::clamp(above + j, 0, height - 1) * width + (left + i + width) % width)].x);
    return sum * Real(scene.background.x);
}

/// Over pi, of a floor in y = 0.
Real irradiance_of(const Scene &scene) {
    constexpr int rings = 1000, spokes = 2000;
    Real sum = 0;
    for (int i = 0; i < rings; ++i) {
        const Real square = (i + 0.5L) / rings, y = std::sqrt(square), r = std::sqrt(1 - square);  // cosine squared is uniform
        for (int j = 0; j < spokes; ++j) {
            const Real angle = 2 * pi * (j + 0.5L) / spokes;
            sum += radiance_from(scene, r * std::cos(angle), y, r * std::sin(angle));
        }
    }
    return sum / (Real(rings) * spokes);
}

struct Sky {
    const char *name;
    std::function<void(Scene &scene)> add;
};

/// A texel for the sun of two degrees, in which is most of the light.
Spectrum sunny(uint column, uint row) { return column == 40 && row == 9 ? Spectrum(1000) : Spectrum(0.2f) * (row < 32 ? 1.0f : 0.1f); }

const std::vector<Sky> skies = {
    {"White", [](Scene &scene) { add_panorama(scene, 2, 1, [](uint, uint) { return Spectrum(1); }); }},
    {"Sunny", [](Scene &scene) { add_panorama(scene, 128, 64, sunny); }},
    {"Turned",
     [](Scene &scene) {
         add_panorama(scene, 128, 64, sunny);
         scene.background = Spectrum(0.7f), scene.background_turn = -0.4f;
     }},
    {"Coarse", [](Scene &scene) { add_panorama(scene, 5, 3, [](uint c, uint r) { return Spectrum(c * r % 3 == 1); }); }},
    {"Large",
     [](Scene &scene) { add_panorama(scene, 2500, 1300, [](uint c, uint r) { return Spectrum((c / 90 + r / 70) % 5 == 0 ? 3.0f : 0.01f); }); }},
};

class Skies : public testing::TestWithParam<Sky> {};

Scene floor_under(const Sky &sky) {
    Scene scene = scene_seen_at({0.3f, 0.12f, -0.5f}, {0, 0, 0});
    scene.integrator.type = "path";
    sky.add(scene);
    add_floor(scene);
    return scene;
}

/// Of a difference as large as that of the means, if both are of the same.
}  // namespace

TEST_P(Skies, LightTheFloorAsTheirIntegralSays) {
    Scene scene = floor_under(GetParam());
    scene.film.spp = 256;
    const Real expected = irradiance_of(scene);
    const Estimate both = estimate(scene);
    expect_mean(both, expected);
    EXPECT_GT(both.shadow_rays, both.samples / 3);
    EXPECT_EQ(both.shadow_hits, 0u);
}

/// By chance alone the sun is met so seldom that only many samples tell.
TEST_P(Skies, GiveTheSameByChanceAlone) {
    Scene scene = floor_under(GetParam());
    scene.film.spp = 64;
    const Estimate both = estimate(scene);
    scene.film.spp = 4096;
    scene.integrator.light_samples = 0;
    const Estimate met = estimate(scene);
    EXPECT_EQ(met.shadow_rays, 0u);
    EXPECT_TRUE(statistics::plausible(p_of(both, met))) << both.mean << " but by chance " << met.mean;
    EXPECT_LT(met.error(), 0.02L * met.mean) << "the test can tell";
}

INSTANTIATE_TEST_SUITE_P(Environment, Skies, testing::ValuesIn(skies), [](const auto &info) { return std::string(info.param.name); });

/// What asking is for: of the sun's light as much noise goes as a hundred times the samples would take.
TEST(Environment, ASunIsAsked) {
    Scene scene = floor_under(skies[1]);
    const Estimate asked = estimate(scene);
    scene.integrator.light_samples = 0;
    scene.film.spp = 256;
    const Estimate met = estimate(scene);
    EXPECT_LT(asked.variance, met.variance / 100);
}

/// Beside lamps, in a scene with things of its own shadow, whatever finds the light.
TEST(Environment, ShinesBesideLampsInCornersAndOnMirrors) {
    Scene scene = floor_under(skies[1]);
    scene.film.spp = 256, scene.integrator.max_depth = 4;
    add_sphere(scene, 1, {0.5f, 1, 0.3f}, 0.3f);
    add_quad(scene, 0, {-0.5f, 0, -1}, {0, 0, 2}, {0, 1, 0});
    add_sphere(scene, add_material(scene, mirror(0.9f)), {0.6f, 0.2f, -0.4f}, 0.2f);
    scene.lights.push_back(directional_light(glm::normalize(vec3(1, 1, 0)), Spectrum(0.4f)));
    scene.lights.push_back(point_light({0, 2, 0}, Spectrum(0.7f)));
    const Estimate both = estimate(scene);
    scene.integrator.light_samples = 0;
    scene.film.spp = 4096;
    const Estimate met = estimate(scene);
    EXPECT_TRUE(statistics::plausible(p_of(both, met))) << both.mean << " but by chance " << met.mean;
    EXPECT_LT(both.error(), 0.01L * both.mean) << "the test can tell";
    EXPECT_LT(met.error(), 0.02L * met.mean) << "the test can tell";
}

/// A convex thing reflects half of 1, whatever its depth; a colour is met by chance alone, and without noise.
TEST(Environment, AFurnaceOfOneIsReflectedByHalf) {
    for (const bool picture : {false, true}) {
        Scene scene = scene_seen_at({0.5f, 2, 0.3f}, {0, 0, 0});
        scene.integrator.type = "path", scene.integrator.max_depth = 6;
        scene.materials[0].record = matte(0.5f);
        add_sphere(scene, 0, {0, 0, 0}, 1);
        scene.background = Spectrum(1);
        if (picture) skies[0].add(scene);
        const Estimate furnace = estimate(scene);
        EXPECT_EQ(furnace.shadow_rays > 0, picture);
        if (picture)
            expect_mean(furnace, 0.5L);
        else
            EXPECT_NEAR(double(furnace.mean), 0.5, 1e-6);
    }
}

/// Of what the eye and mirrors see, nothing is shared with what is asked.
TEST(Environment, IsSeenAsItIs) {
    Scene scene = scene_seen_at({0, 0.5f, 1}, {0, 0, 0});
    scene.integrator.type = "path", scene.integrator.max_depth = 2;
    skies[2].add(scene);
    const Real above = radiance_from(scene, 0, std::sqrt(0.2L), -std::sqrt(0.8L));
    add_quad(scene, add_material(scene, mirror(1)), {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
    add_sphere(scene, 0, {0, -2, 0}, 1);
    EXPECT_NEAR(double(estimate(scene).mean), double(above), 1e-3 * double(above));
}

/// Neither batches, nor kernels made for more than the scene has, nor accelerators matter.
TEST(Environment, GivesTheSameBitsHoweverItIsRendered) {
    for (const bool has_sky : {true, false}) {
        Scene scene = scene_seen_at({0.4f, 1.1f, 0.5f}, {0, 0, 0});
        scene.cameras[0].fov = 1;
        scene.integrator.type = "path", scene.integrator.max_depth = 4;
        if (has_sky) skies[1].add(scene);
        add_floor(scene), add_quad(scene, 1, {-1, 0.5f, -1}, {2, 0.5f, 0}, {0, 0, 1});
        add_sphere(scene, add_material(scene, glass(1.5f)), {0, 0.3f, 0}, 0.3f);
        expect_same_bits(scene);
    }
}
