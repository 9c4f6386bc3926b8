#include "scene/meshes/default_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "scene/lights/light.h"
#include "tests/scene/meshes/mesh_folder.h"

namespace brandung {
namespace {

/// A closed box, its sides facing outwards, or inwards without the one at +z.
MeshPart box(vec3 low, vec3 high, bool room) {
    MeshPart part{0, {}};
    for (int i = 0; i < 8; ++i) part.mesh.positions.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    const uint sides[6][4] = {{4, 5, 7, 6}, {0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (int s = room ? 1 : 0; s < 6; ++s)
        for (const int k : {0, 1, 2, 0, 2, 3}) part.mesh.indices.push_back(sides[s][room ? 3 - k : k]);
    return part;
}

TEST(FramingCamera, SeesTheWholeSphereAroundABoxOfAnySizeInAPictureOfAnyShape) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0.1f, 1);
    for (int i = 0; i < 100; ++i) {
        const float scale = std::exp2(float(i % 40 - 20));
        const vec3 center = scale * vec3(uniform(random), uniform(random), -uniform(random));
        const vec3 half = scale * vec3(uniform(random), uniform(random), uniform(random));
        std::vector<MeshPart> parts;
        parts.push_back(box(center - half, center + half, false));
        FilmSettings film;
        film.width = uint(400 * uniform(random)), film.height = uint(400 * uniform(random));
        const CameraDescription camera = frame(parts, film, {{}, {}, {}, uniform(random)}).camera;
        const double radius = glm::length(half), distance = glm::length(camera.from - camera.at), tan_y = std::tan(camera.fov / 2);
        const double half_angle = std::atan(tan_y * std::min(1.0, double(film.width) / film.height));
        EXPECT_NEAR(std::asin(radius / distance) / half_angle, 1, 1e-3) << i;
        EXPECT_LT(glm::length(camera.at - center), 1e-5 * radius);
        const vec3 way = (camera.from - camera.at) / float(distance);
        EXPECT_NEAR(way.y, std::sin(20 * std::numbers::pi / 180), 1e-5);
        EXPECT_NEAR(std::atan2(way.x, way.z), 30 * std::numbers::pi / 180, 1e-5);
    }
}

TEST(FramingCamera, StandsOnTheGroundThatUpGives) {
    std::vector<MeshPart> parts;
    parts.push_back(box(vec3(-1), vec3(1), false));
    const CameraDescription camera = frame(parts, {}, {{}, {}, vec3(0, 0, 2), {}}).camera;
    const vec3 way = glm::normalize(camera.from - camera.at);
    EXPECT_NEAR(way.z, std::sin(20 * std::numbers::pi / 180), 1e-5);
    EXPECT_LT(way.y, -0.8f);  // -y is in front
    EXPECT_FALSE(view_fault(camera));
}

/// The eye is straight before the missing wall, and all corners are in the picture: the nearest, at (1, 1, 1), touch 1 / 1.05 of it.
TEST(FramingCamera, LooksIntoARoom) {
    std::vector<MeshPart> parts;
    parts.push_back(box(vec3(-1), vec3(1), true));
    const CameraDescription camera = frame(parts, {}, {}).camera;
    EXPECT_NEAR(camera.from.x, 0, 1e-6);
    EXPECT_NEAR(camera.from.y, 0, 1e-6);
    EXPECT_NEAR(camera.from.z, 1.05 * (1 + 1 / std::tan(camera.fov / 2)), 1e-4);
}

/// A floor with things on it, parts that are open to the front: its middle sees sky.
TEST(FramingCamera, LooksDownOnAFloor) {
    MeshPart floor{0, {}};
    floor.mesh.positions = {{-4, 0, 4}, {4, 0, 4}, {4, 0, -4}, {-4, 0, -4}, {-3, 0, -3.5f}, {3, 0, -3.5f}, {3, 3, -3.5f}, {-3, 3, -3.5f}};
    floor.mesh.indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    std::vector<MeshPart> parts;
    parts.push_back(std::move(floor));
    const CameraDescription camera = frame(parts, {}, {}).camera;
    EXPECT_GT(camera.from.y - camera.at.y, 0.3f * glm::length(camera.from - camera.at));
}

/// It covers 5/6 of the half sphere around -z; that the ceiling is missing, too, turns the vector area by 45 degrees.
TEST(FramingCamera, LooksIntoARoomWithoutCeilingAsWell) {
    std::vector<MeshPart> parts;
    parts.push_back(box(vec3(-1), vec3(1), true));
    std::vector<uint> &indices = parts[0].mesh.indices;
    indices.erase(indices.begin() + 12, indices.begin() + 18);  // the side of y = 1
    const CameraDescription camera = frame(parts, {}, {}).camera;
    EXPECT_NEAR(camera.from.x, 0, 1e-6);
    EXPECT_NEAR(camera.from.y, 0, 1e-6);
    EXPECT_GT(camera.from.z, 1);
}

TEST(Headlight, LightsWhatFacesItWithPiWattsWhateverTheScale) {
    for (const float scale : {1e-4f, 1.0f, 1e6f}) {
        std::vector<MeshPart> parts;
        parts.push_back(box(vec3(-scale), vec3(scale), false));
        const Framing framing = frame(parts, {}, {});
        const CameraDescription &camera = framing.camera;
        PointLight light;
        std::memcpy(&light, headlight(framing).words, sizeof light);
        EXPECT_EQ(light.attenuation, vec3(1, 0, 0));
        EXPECT_FLOAT_EQ(light.intensity.y, std::numbers::pi_v<float>);
        const vec3 to_light = glm::normalize(light.position - camera.at), to_eye = glm::normalize(camera.from - camera.at);
        EXPECT_GT(glm::dot(to_light, to_eye), 0.8f);
        EXPECT_GT(to_light.y, to_eye.y);
    }
}

TEST(DefaultView, IsThatOfFilesWithoutCamerasAndLights) {
    MeshFolder folder;
    folder.write("lamp.mtl", "newmtl lamp\nKe 1 1 1\n");
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const Scene plain = read_scene(folder.write("plain.obj", triangle + "f 1 2 3\n"));
    EXPECT_EQ(plain.cameras.size(), 1u);
    EXPECT_EQ(plain.lights.size(), 1u);
    EXPECT_EQ(plain.ambient, Spectrum(0.1f));
    EXPECT_EQ(plain.film.spp, 16u);
    ASSERT_EQ(plain.notes.size(), 3u);
    EXPECT_EQ(plain.notes[0].substr(0, 15), "camera: --from ");
    EXPECT_EQ(plain.notes[1], "samples: --spp 16 --light-samples 2");
    const char *begin_of_scene = R"(scene: {"film": {"width": 512, "height": 512, "spp": 16}, "integr)";
    EXPECT_EQ(plain.notes[2].substr(0, 65), begin_of_scene);
    const Scene lamp = read_scene(folder.write("lamp.obj", "mtllib lamp.mtl\n" + triangle + "usemtl lamp\nf 1 2 3\n"));
    EXPECT_TRUE(lamp.lights.empty());
    ASSERT_EQ(lamp.notes.size(), 3u);
    EXPECT_EQ(lamp.notes[2].substr(0, 65), begin_of_scene);
    // Radiance 1 times area 1/2, at the distance sqrt(1/2): the irradiance 1, of which a tenth is that of ambient light, pi times its radiance.
    EXPECT_FLOAT_EQ(lamp.ambient.x, float(0.1 / std::numbers::pi));
    EXPECT_EQ(read_scene(folder.write("plain.obj", triangle + "f 1 2 3\n"), {{"film.pixel=corner"}, {}, {}}).film.spp, 1u);
}

/// A triangle of area 1/2 in a sphere of radius sqrt(1/2): its emission L gives the irradiance L, of which 0.01 pi = 0.0314 suffice.
TEST(DefaultView, HasNoLightWhereMeshesLightThemselves) {
    MeshFolder folder;
    const std::string file = folder.write("lamp.obj", "mtllib lamp.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl lamp\nf 1 2 3\n");
    const auto lights = [&](const std::string &emission, const std::vector<std::string> &settings) {
        folder.write("lamp.mtl", "newmtl lamp\nKe " + emission + "\n");
        return read_scene(file, {settings, {}, {}}).lights.size();
    };
    EXPECT_EQ(lights("0 0.032 0", {}), 0u);
    EXPECT_EQ(lights("0 0.031 0", {}), 1u);
    EXPECT_EQ(lights("0 0.032 0", {"integrator.light_samples=0"}), 1u);
}

std::string error_of(const std::string &file, const ViewChanges &changes = {}) try {
    read_scene(file, {{}, changes, {}});
    return "";
} catch (const SceneError &error) {
    return std::string(error.what()).substr(file.size());
}

TEST(DefaultView, MeshesWithNothingToSeeAreErrorsThatSayWhy) {
    MeshFolder folder;
    const std::string none = ": has no faces with an area, so that nothing of it can be seen";
    EXPECT_EQ(error_of(folder.write("points.obj", "v 1 2 3\n")), none);
    EXPECT_EQ(error_of(folder.write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf 1 1 1\n")), none + "; triangle without area: left out (2)");
    EXPECT_EQ(error_of(folder.write("point.obj", "v 1e9 0 0\nf 1 1 1\n")), none + "; triangle without area: left out (1)");
}

/// Floats around 1e8 are 8 apart: an eye at a sixth of that from the middle would be in it.
TEST(DefaultView, MeshesWithoutAPlaceForTheirCameraAreErrors) {
    MeshFolder folder;
    const std::string far = folder.write("far.obj", "v 1e8 0 0\nv 1e8 1 0\nv 1e8 0 1\nf 1 2 3\n");
    const float wide = glm::radians(179.9f);
    EXPECT_EQ(error_of(far, {{}, {}, {}, wide}),
              ": is so small and so far from the origin that floats have no place for a camera beside it; --from gives one");
    EXPECT_EQ(error_of(far, {vec3(0), {}, {}, wide}), "");
    const std::string near = folder.write("near.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(error_of(near, {vec3(1), vec3(1), {}, {}}), ": camera \"camera\", as changed: \"at\" must differ from \"from\"");
}

TEST(ViewChanges, ReplaceWhatTheyHave) {
    MeshFolder folder;
    const std::string file = folder.write("scene.json", R"({"camera": {"from": [0, 0, 5], "at": [0, 0, 0], "fov": 30}})");
    const CameraDescription camera = read_scene(file, {{}, {vec3(1, 2, 3), {}, {}, 1.0f}, {}}).cameras.at(0);
    EXPECT_EQ(camera.from, vec3(1, 2, 3));
    EXPECT_EQ(camera.at, vec3(0));
    EXPECT_EQ(camera.fov, 1.0f);
    EXPECT_EQ(view_options(camera), "--from 1,2,3 --at 0,0,0 --up 0,1,0 --fov 57.3");
    EXPECT_THROW(read_scene(file, {{}, {vec3(0), {}, {}, {}}, {}}), SceneError);
}

/// A quarter of a turn about a slanted axis of any length, seen from its tip: x, y, z go round.
TEST(ViewChanges, TurnedCamerasKeepTheirDistance) {
    CameraDescription camera;
    camera.at = vec3(1), camera.from = vec3(3, 1, 1), camera.up = vec3(2);
    const vec3 third = turned(camera, 2 * std::numbers::pi / 3).from;
    EXPECT_LT(glm::length(third - vec3(1, 3, 1)), 1e-6f);
    EXPECT_LT(glm::length(turned(camera, 2 * std::numbers::pi).from - camera.from), 1e-6f);
}

TEST(MeshObject, IsAFileOfTheScenesFolderWithMaterialsOfItsOwnOrTheScenes) {
    MeshFolder folder;
    folder.write("red.mtl", "newmtl red\nKd 1 0 0\n");
    folder.write("red.obj", "mtllib red.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
    const std::string begin = R"({"camera": {"from": [0, 0, 5], "at": [0, 0, 0]}, "materials": [{"name": "green", "type": "whitted"}],
"objects": [
{"type": "mesh", "file": ")",
                      end = "}]}";
    const Scene scene = read_scene(folder.write("scene.json", begin + R"(red.obj"}, {"type": "mesh", "file": "red.obj", "material": "green")" + end));
    ASSERT_EQ(scene.shapes.size(), 2u);
    EXPECT_EQ(scene.materials.at(scene.shapes[0]->material).name, "red.obj:red");
    EXPECT_EQ(scene.materials.at(scene.shapes[1]->material).name, "green");
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_TRUE(scene.warnings.contains("the scene has neither lights nor ambient light nor emission: its objects are black"));
    const auto error = [&](const std::string &file) {
        try {
            read_scene(folder.write("scene.json", begin + file + "\"" + end));
        } catch (const SceneError &fault) {
            return std::string(fault.what());
        }
        return std::string();
    };
    EXPECT_NE(error("blue.obj").find("scene.json:3: /objects/0/file: "), std::string::npos);
    EXPECT_NE(error("blue.obj").find("blue.obj: no such file"), std::string::npos);
    EXPECT_NE(error("red.mtl").find("scene.json:3: /objects/0/file: "), std::string::npos);
    EXPECT_NE(error("red.mtl").find("red.mtl: unknown format of meshes \".mtl\"; known by extension: .obj .ply"), std::string::npos);
}

TEST(MeshObject, WarningsHaveThePlaceOfTheirFirstCause) {
    MeshFolder folder;
    const std::string mesh = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 2 3\nf 1 2 3\nfoo\nf 1 1 2\n");
    const std::string file = folder.write("scene.json", R"({"camera": {"from": [0, 0, 5], "at": [0, 0, 0]}, "ambient": 1, "objects": [
{"type": "mesh", "file": "a.obj"}],
"materials": [{"name": "a", "type": "whitted", "diffuse": 2}]})");
    const std::map<std::string, std::string> expected = {
        {"diffuse reflectance above 1: more light leaves than arrives; colours are from 0 to 1", file + ":3: /materials/0"},
        {"lines (l): left out", mesh + ":4"},
        {"triangle without area: left out", file + ":2: /objects/0"},
        {"unknown statement: left out", mesh + ":7"}};
    const Scene scene = read_scene(file);
    EXPECT_EQ(scene.warning_places, expected);
    EXPECT_EQ(scene.files, (std::vector<std::string>{file, mesh}));
}

/// Neither libraries nor textures, and no warnings of them.
TEST(MeshObject, WithAMaterialOfTheScenesReadsNoneOfItsFile) {
    MeshFolder folder;
    const std::string ply =
        "ply\nformat ascii 1.0\ncomment TextureFile none.png\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    folder.write("a.ply", ply);
    folder.write("a.mtl", "newmtl a\nmap_Kd none.png\nfoo\n");
    folder.write("a.obj", "mtllib a.mtl none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n");
    const auto read = [&](const std::string &material) {
        return read_scene(folder.write("scene.json", R"({"camera": {"from": [0, 0, 5], "at": [0, 0, 0]}, "ambient": 1,
"materials": [{"name": "green", "type": "whitted"}],
"objects": [{"type": "mesh", "file": "a.obj")" + material +
                                                         R"(}, {"type": "mesh", "file": "a.ply")" + material + "}]}"));
    };
    const Scene scene = read(R"(, "material": "green")");
    EXPECT_EQ(scene.shapes.size(), 3u);
    EXPECT_EQ(scene.materials.size(), 1u);
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.begin()->first;
    EXPECT_EQ(read("").warnings.size(), 4u) << "no texture, no library, no material, an unknown statement";
}

}  // namespace
}  // namespace brandung
