#include "tools/scene_objects.h"

#include <gtest/gtest.h>

#include "scene/primitives/add.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

using nlohmann::json;

/// A light without size, then a ball and a triangle that shine.
Scene lamps() {
    Scene scene;
    scene.file = "scene";
    scene.lights.push_back(point_light({0, 5, 0}, Spectrum(1)));
    Material shining = matte(0.5f);
    shining.emission = Spectrum(1);
    const uint lamp = add_material(scene, shining);
    add_sphere(scene, lamp, {0, 0, 0}, 1);
    add_triangle(scene, lamp, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    return scene;
}

/// Strata of a sphere are a grid, those of a mesh lie along a curve; a light comes before them.
TEST(SceneObjects, TellsStrataOfSpheresAndMeshes) {
    Scene scene = lamps();
    scene.integrator.light_samples = 2;
    SceneObjects objects(scene);
    EXPECT_EQ(objects.light(0)["emissive"], nullptr);
    EXPECT_EQ(objects.light(3)["emissive"]["stratum"], json({{"column", 0}, {"row", 1}, {"rows", 2}}));
    EXPECT_EQ(objects.light(7)["emissive"]["stratum"], json({{"cell", 2}, {"cells", 4}}));
    EXPECT_EQ(objects.light(7)["emissive"]["kind"], "triangle");
}

/// Paths choose among a shape's faces, and ask the background, which is none of the file's lights.
TEST(SceneObjects, TellsFacesThatPathsChooseAndTheBackground) {
    Scene scene = lamps();
    scene.integrator.type = "path";
    scene.background = Spectrum(1);
    scene.textures.push_back({"", {.wrap = TextureWrap::panorama}, {2, 1, {vec3(1), vec3(1)}, {}}});
    scene.background_texture = 1;
    SceneObjects objects(scene);
    EXPECT_EQ(objects.light(0)["light"], 0);
    EXPECT_EQ(objects.light(3)["kind"], "environment");
    EXPECT_EQ(objects.light(3)["light"], nullptr);
    EXPECT_EQ(objects.light(1)["emissive"]["stratum"], json({{"column", 0}, {"row", 0}, {"rows", 1}}));
    EXPECT_EQ(objects.light(2)["emissive"]["stratum"], json({{"cell", 0}, {"cells", 1}}));
}

}  // namespace
}  // namespace brandung
