/// Surfaces that shine on one side only: what they light, and how they look, by every integrator.
#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "scene/primitives/add.h"
#include "tests/images/irradiance.h"

namespace {

using namespace brandung;
using namespace irradiance;

/// A lamp over or around the floor's middle, and which of its sides the floor sees.
struct Lamp {
    const char *name;
    std::function<void(Scene &scene)> add;
    bool front, back;
};

/// Makes what was added to the world a group, which is seen where the map places it.
void place(Scene &scene, const AffineMap &map) {
    const uint group = add_group(scene, "lamp", std::exchange(scene.shapes, {}));
    ASSERT_FALSE(add_instance(scene, group, map, NO_MATERIAL));
}

/// Its front faces the floor.
void add_quad_lamp(Scene &scene) { add_quad(scene, 1, {-1, 0.5f, -1}, {2, 0.5f, 0}, {0, 0, 1}); }

const std::vector<Lamp> lamps = {
    {"Quad", add_quad_lamp, true, false},
    {"QuadFromBehind",
     [](Scene &scene) {
         add_quad(scene, 1, {-1, 0.5f, -1}, {0, 0, 1}, {2, 0.5f, 0});
     },
     false, true},
    {"MirroredQuad",
     [](Scene &scene) {
         add_quad_lamp(scene), place(scene, scaling({-1, 1, 0.5}));
     },
     true, false},
    {"QuadTurnedOver",
     [](Scene &scene) {
         add_quad_lamp(scene), place(scene, then(rotation(180, {0, 0, 1}), translation({0, 2, 0})));
     },
     false, true},
    // Triangles of a parallelogram of which one is turned over are no face.
    {"Crossed",
     [](Scene &scene) {
         add_triangle_mesh(scene, 1, {.positions = {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}}, .indices = {0, 1, 2, 0, 3, 2}});
     },
     true, true},
    {"Disk",
     [](Scene &scene) {
         add_disk(scene, 1, {0, 1, 0}, {0.2f, -1, 0}, 0.7f);
     },
     true, false},
    {"DiskFromBehind",
     [](Scene &scene) {
         add_disk(scene, 1, {0, 1, 0}, {0.2f, 1, 0}, 0.7f);
     },
     false, true},
    {"MirroredDisk",
     [](Scene &scene) {
         add_disk(scene, 1, {0, 1, 0}, {0.2f, -1, 0}, 0.7f), place(scene, scaling({-1, 1, 0.5}));
     },
     true, false},
    {"Sphere",
     [](Scene &scene) {
         add_sphere(scene, 1, {0.5f, 1, 0.3f}, 0.8f);
     },
     true, false},
    {"SphereAround",
     [](Scene &scene) {
         add_sphere(scene, 1, {0.5f, 0.2f, 0.3f}, 2);
     },
     false, true},
    {"MirroredSphere",
     [](Scene &scene) {
         add_sphere(scene, 1, {0, 0, 0}, 1), place(scene, then(scaling({-1, 0.5, 1}), translation({0, 1, 0})));
     },
     true, false},
    {"Cone",
     [](Scene &scene) {
         add_frustum(scene, 1, {0, 2, 0}, 1, {0, 1, 0}, 0.0f);
     },
     true, false},
    {"OpenCylinder",
     [](Scene &scene) {
         add_frustum(scene, 1, {0.6f, 0.5f, 0}, 0.3f, {0.6f, 1.2f, 0}, 0.3f);
     },
     true, true},
};

class OneSided : public testing::TestWithParam<Lamp> {};

Real mean_with(Scene &scene, uint dark) {
    scene.materials[1].record.flags = dark;
    return estimate(scene).mean;
}

}  // namespace

/// Each side gives its part of what both give, from the same samples; a side that is not seen gives nothing.
TEST_P(OneSided, LightsWhatItsSideFaces) {
    for (const auto &[integrator, light_samples] : {std::pair("whitted", 1u), std::pair("path", 1u), std::pair("path", 0u)}) {
        Scene scene = scene_seen_at({0.3f, 0.12f, -0.5f}, {0, 0, 0});
        scene.integrator.type = integrator, scene.integrator.light_samples = light_samples;
        GetParam().add(scene);
        add_floor(scene);
        const Real both = mean_with(scene, 0), front = mean_with(scene, MATERIAL_DARK_BACK), back = mean_with(scene, MATERIAL_DARK_FRONT);
        ASSERT_GT(both, 0.01L);
        EXPECT_NEAR(double(front + back), double(both), 1e-5 * double(both)) << integrator;
        EXPECT_EQ(front > 0, GetParam().front) << integrator << ", " << light_samples;
        EXPECT_EQ(back > 0, GetParam().back) << integrator << ", " << light_samples;
    }
}

INSTANTIATE_TEST_SUITE_P(Emission, OneSided, testing::ValuesIn(lamps), [](const auto &info) { return std::string(info.param.name); });

/// The lamp itself, from both sides.
TEST(OneSidedEmission, LooksBlackFromTheOtherSide) {
    for (const char *integrator : {"whitted", "path"})
        for (const float height : {-3.0f, 3.0f}) {
            Scene scene = scene_seen_at({0, height, 0}, {0, 0.75f, -0.5f});
            scene.integrator.type = integrator;
            add_quad_lamp(scene);
            EXPECT_EQ(mean_with(scene, MATERIAL_DARK_BACK), height < 0 ? 1 : 0) << integrator;
            EXPECT_EQ(mean_with(scene, MATERIAL_DARK_FRONT), height < 0 ? 0 : 1) << integrator;
            EXPECT_EQ(mean_with(scene, 0), 1) << integrator;
        }
}

/// Glass, from within which surface points lie on the side away from the ray: the ray from above meets the outside of the upper face, and the inside
/// of the lower one.
TEST(OneSidedEmission, OfGlassIsOfTheSideThatARayMeets) {
    Scene scene = scene_seen_at({0.1f, 3, 0.2f}, {0, 0, 0});
    scene.integrator.type = "path", scene.integrator.max_depth = 3;
    scene.materials[1].record = glass(1);
    scene.materials[1].record.emission = Spectrum(1);
    add_sphere(scene, 1, {0, 0, 0}, 1);
    for (const auto &[dark, expected] : {std::pair(0u, 2), std::pair(MATERIAL_DARK_BACK, 1), std::pair(MATERIAL_DARK_FRONT, 1)}) {
        scene.materials[1].record.flags = glass(1).flags | dark;
        EXPECT_NEAR(double(estimate(scene).mean), expected, 1e-4) << dark;
    }
}
