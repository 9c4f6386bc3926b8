/// Path tracing against what analysis and Whitted's integrator know.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "scene/compile.h"
#include "scene/kinds.h"
#include "scene/lights/light.h"
#include "scene/primitives/add.h"
#include "scene/samplers/sampler.h"
#include "tests/images/irradiance.h"

namespace {

using namespace brandung;
using namespace irradiance;

/// Of 4096 pixels, so that their variance tells their error.
void take_independent_samples(Scene &scene, uint spp) {
    scene.film.sampler = kind_number(sampler_kinds(), "independent");
    scene.film.width = 64, scene.film.height = 64, scene.film.spp = spp;
}

/// A closed sphere of radius 1 from within.
Scene furnace(uint depth, Spectrum emission) {
    Scene scene = scene_seen_at({0.3f, 0.2f, -0.4f}, {-1, 0.5f, 0.7f});
    scene.cameras[0].fov = 1;
    scene.integrator.type = "path", scene.integrator.max_depth = depth;
    scene.materials.clear();
    Material material = matte(0.5f);
    material.emission = emission;
    add_sphere(scene, add_material(scene, material), {0, 0, 0}, 1);
    return scene;
}

/// Of a difference as large as that of the means, if both are of the same.
class Depth : public testing::TestWithParam<uint> {};

}  // namespace

/// Every surface adds its half of what comes from all the others, and the last one the light that it asks.
TEST_P(Depth, ASphereThatShinesAndReflectsAHalfHasOneButWhatDepthCuts) {
    const Real expected = 1 - std::exp2(-Real(GetParam()) - 1);
    Scene scene = furnace(GetParam(), Spectrum(0.5f));
    expect_mean(estimate(scene), expected);

    scene.integrator.light_samples = 0;
    expect_mean(estimate(scene), expected);
}

/// Irradiance π on all of the sphere at once, and half of that by each reflection: no sample differs from another, unless chance ends its path.
TEST_P(Depth, ASphereAroundAPointLightHasOneButWhatDepthCuts) {
    Scene scene = furnace(GetParam(), Spectrum(0));
    scene.integrator.roulette_depth = 1000;
    scene.lights.push_back(point_light({0, 0, 0}, Spectrum(oracle::pi)));
    const Real expected = 1 - std::exp2(-Real(GetParam()));
    const Estimate all = estimate(scene);
    EXPECT_NEAR(double(all.mean), double(expected), 1e-5);
    EXPECT_LT(all.variance, 1e-9L);

    scene.integrator.roulette_depth = 1;
    expect_mean(estimate(scene), expected);
}

INSTANTIATE_TEST_SUITE_P(PathFurnace, Depth, testing::Values(1u, 2u, 4u, 12u), [](const auto &info) { return "Depth" + std::to_string(info.param); });

namespace {

/// Lamps over a floor that is seen at the origin.
struct Lamps {
    const char *name;
    std::function<void(Scene &scene)> add;
};

/// Makes what was added to the world a group, which is seen turned, stretched and moved up.
void place_stretched(Scene &scene) {
    const uint group = add_group(scene, "lamps", std::exchange(scene.shapes, {}));
    const AffineMap map = then(then(rotation(30, {1, 2, 3}), scaling({0.5, 1.2, 2})), translation({0.3, 1.6, 0}));
    ASSERT_FALSE(add_instance(scene, group, map, NO_MATERIAL));
}

void add_quad_lamp(Scene &scene) { add_quad(scene, 1, {-1, 0.5f, -1}, {2, 0.5f, 0}, {0, 0, 1}); }

const std::vector<Lamps> all_lamps = {
    {"Quad", add_quad_lamp},
    {"Sphere",
     [](Scene &scene) {
         add_sphere(scene, 1, {0.5f, 1, 0.3f}, 0.8f);
     }},
    {"SmallSphere",
     [](Scene &scene) {
         add_sphere(scene, 1, {1, 2, 0.3f}, 0.05f);
     }},
    {"SphereAround",
     [](Scene &scene) {
         add_sphere(scene, 1, {0.5f, 0.2f, 0.3f}, 2);
     }},
    {"Cylinder",
     [](Scene &scene) {
         scene.shapes.push_back(make_frustum(1, {-1, 0.5f, 0}, 0.3f, {1, 1, 0.5f}, 0.1f));
     }},
    {"Disk",
     [](Scene &scene) {
         add_disk(scene, 1, {0.3f, 0.8f, 0.2f}, {0.2f, -1, 0.1f}, 0.6f);
     }},
    {"StretchedDisk",
     [](Scene &scene) {
         add_disk(scene, 1, {0, 0, 0}, {0.2f, 1, 0.1f}, 1), place_stretched(scene);
     }},
    {"StretchedSphere",
     [](Scene &scene) {
         add_sphere(scene, 1, {0, 0, 0}, 1), place_stretched(scene);
     }},
    {"StretchedQuads",
     [](Scene &scene) {
         add_quad_lamp(scene), add_quad(scene, 1, {-1, 0, -1}, {1, 0.5f, 0}, {0, 0, 1}), place_stretched(scene);
     }},
    {"Directional", [](Scene &scene) { scene.lights.push_back(directional_light(glm::normalize(vec3(1, 1, 0)), Spectrum(0.4f))); }},
    {"Several",
     [](Scene &scene) {
         const uint bright = add_material(scene, emitter(Spectrum(5, 1, 0)));
         add_quad_lamp(scene), add_sphere(scene, bright, {2, 1, 1}, 0.3f), add_sphere(scene, 1, {-2, 1, 1}, 0.3f);
         scene.lights.push_back(point_light({0, 2, 0}, Spectrum(0.7f)));
         scene.lights.push_back(spot_light({1, 2, 1}, {0, 0, 0}, Spectrum(2), 40, 0.3));
     }},
};

class PathLamps : public testing::TestWithParam<Lamps> {};

}  // namespace

/// Light asked and light met share what Whitted's integrator finds by asking alone. Neither way by itself needs the other.
TEST_P(PathLamps, GiveWhatWhittedFindsBothWaysTogetherAndByChanceAlone) {
    Scene scene = scene_seen_at({0.3f, 0.12f, -0.5f}, {0, 0, 0});
    take_independent_samples(scene, 256);
    GetParam().add(scene);
    add_floor(scene);
    const Estimate whitted = estimate(scene);
    ASSERT_GT(whitted.shadow_rays, 0u) << "what is seen is the floor, no lamp";
    scene.integrator.type = "path";
    const Estimate both = estimate(scene);
    EXPECT_TRUE(statistics::plausible(p_of(both, whitted))) << both.mean << " instead of " << whitted.mean;
    EXPECT_LT(std::max(both.error(), whitted.error()), 0.003L * both.mean) << "the test can tell";
    if (!scene.lights.empty()) return;  // which no ray meets
    scene.integrator.light_samples = 0;
    const Estimate met = estimate(scene);
    EXPECT_TRUE(statistics::plausible(p_of(met, whitted))) << met.mean << " instead of " << whitted.mean;
    EXPECT_EQ(met.shadow_rays, 0u);
}

INSTANTIATE_TEST_SUITE_P(Path, PathLamps, testing::ValuesIn(all_lamps), [](const auto &info) { return std::string(info.param.name); });

namespace {

/// A lamp of few faces, with the normals of a ball.
MeshData ball(vec3 center, float radius, int rings, int sectors) {
    MeshData mesh;
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            const double down = oracle::pi * i / rings, around = 2 * oracle::pi * j / sectors;
            const vec3 normal(std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around));
            mesh.normals.push_back(normal), mesh.positions.push_back(center + normal * radius);
        }
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            const uint a = uint(i * sectors + j), b = uint(i * sectors + (j + 1) % sectors), c = a + uint(sectors), d = b + uint(sectors);
            if (i > 0) mesh.indices.insert(mesh.indices.end(), {a, b, c});
            if (i + 1 < rings) mesh.indices.insert(mesh.indices.end(), {b, d, c});
        }
    return mesh;
}

}  // namespace

/// Faces of a lamp are asked where they are, and so are met, whatever surface their normals are of.
TEST(Path, LampsWithVertexNormalsAreAskedWhereTheyAreMet) {
    Scene scene = scene_seen_at({0.6f, 0.04f, 0.1f}, {0.25f, 0, 0});
    scene.integrator.type = "path";
    take_independent_samples(scene, 1024);
    add_floor(scene);
    add_triangle_mesh(scene, 1, ball({0, 0.55f, 0}, 0.5f, 4, 6));
    const Estimate both = estimate(scene);
    scene.integrator.light_samples = 0;
    const Estimate met = estimate(scene);
    EXPECT_TRUE(statistics::plausible(p_of(both, met))) << both.mean / met.mean;
    EXPECT_LT(both.error() + met.error(), 1e-3L * met.mean) << "the test can tell";
}

/// The picture is a function of the scene: neither of how it is cut into batches, nor of kernels made for more than it has.
TEST(Path, BatchesAndKernelsForEverythingGiveTheSameBits) {
    Scene scene = scene_seen_at({0.4f, 1.1f, 0.5f}, {0, 0, 0});
    scene.cameras[0].fov = 1;
    scene.integrator.type = "path", scene.integrator.max_depth = 5;
    add_floor(scene), add_quad_lamp(scene);
    add_sphere(scene, add_material(scene, glass(1.5f)), {0, 0.3f, 0}, 0.3f);
    add_sphere(scene, add_material(scene, mirror(0.9f)), {0.5f, 0.2f, 0.1f}, 0.2f);
    expect_same_bits(scene);
}

namespace {

/// A lamp that a board keeps from shining on the table at y = 0; what it sends to the mirror at x = 2 comes to the table's point (1, 0, 0) over it,
/// as if from a lamp at x = 6.
Scene lamp_mirror_table(float lamp_at) {
    Scene scene = scene_seen_at({1.5f, 2, 0.5f}, {1, 0, 0});
    take_independent_samples(scene, 1024);
    scene.integrator.max_depth = 2;
    add_quad(scene, 0, {0, 0, 1}, {1.9f, 0, 0}, {0, 0, -2});
    add_quad(scene, 1, {lamp_at, 0.95f, -2}, {0, 0.15f, 0}, {0, 0, 4});
    return scene;
}

}  // namespace

TEST(PathTraps, AMirrorLightsTheTableAsALampBehindItWould) {
    const Estimate behind = estimate(lamp_mirror_table(6));
    Scene scene = lamp_mirror_table(-2);
    add_quad(scene, 0, {-1, 0.5f, -2}, {0, 0, 4}, {0, 0.25f, 0});
    add_quad(scene, add_material(scene, mirror(1)), {2, 0, -2}, {0, 0, 4}, {0, 2, 0});
    EXPECT_EQ(estimate(scene).mean, 0) << "Whitted leaves it dark";
    scene.integrator.type = "path";
    const Estimate path = estimate(scene);
    EXPECT_TRUE(statistics::plausible(p_of(path, behind))) << path.mean << " instead of " << behind.mean;
    EXPECT_LT(path.error(), 0.015L * path.mean) << "the test can tell";
}

/// A lamp under a shade lights the floor, and the floor the ceiling.
TEST(PathTraps, AFloorLightsTheCeiling) {
    Scene scene = scene_seen_at({0.4f, 0.5f, 0.3f}, {0, 2, 0});
    take_independent_samples(scene, 512);
    scene.integrator.max_depth = 2;
    add_floor(scene);
    add_quad(scene, 0, {-3, 2, -3}, {6, 0, 0}, {0, 0, 6});
    add_quad(scene, 1, {0.5f, 1, -0.5f}, {1, 0, 0}, {0, 0, 1});
    add_quad(scene, 0, {0.4f, 1.05f, -0.6f}, {1.2f, 0, 0}, {0, 0, 1.2f});
    EXPECT_EQ(estimate(scene).mean, 0) << "Whitted leaves it dark";
    scene.integrator.type = "path";
    const Estimate both = estimate(scene);
    scene.integrator.light_samples = 0;
    const Estimate met = estimate(scene);
    EXPECT_GT(both.mean, 0.02L);
    EXPECT_TRUE(statistics::plausible(p_of(both, met))) << both.mean << " but by chance " << met.mean;
    EXPECT_LT(std::max(both.error(), met.error()), 0.005L * both.mean) << "the test can tell";
}
