#include "tools/scene_objects.h"

#include <gtest/gtest.h>

#include "scene/primitives/add.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

using nlohmann::json;

/// Strata of a sphere are a grid, those of a mesh lie along a curve; a light comes before them.
TEST(SceneObjects, TellsStrataOfSpheresAndMeshes) {
    Scene scene;
    scene.file = "scene";
    scene.integrator.light_samples = 2;
    scene.lights.push_back(point_light({0, 5, 0}, Spectrum(1)));
    Material shining = matte(0.5f);
    shining.emission = Spectrum(1);
    const uint lamp = add_material(scene, shining);
    add_sphere(scene, lamp, {0, 0, 0}, 1);
    add_triangle(scene, lamp, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    SceneObjects objects(scene);
    EXPECT_EQ(objects.light(0)["emissive"], nullptr);
    EXPECT_EQ(objects.light(3)["emissive"]["stratum"], json({{"column", 0}, {"row", 1}, {"rows", 2}}));
    EXPECT_EQ(objects.light(7)["emissive"]["stratum"], json({{"cell", 2}, {"cells", 4}}));
    EXPECT_EQ(objects.light(7)["emissive"]["kind"], "triangle");
}

}  // namespace
}  // namespace brandung
