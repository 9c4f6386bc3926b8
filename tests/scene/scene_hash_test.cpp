#include "scene/scene_hash.h"

#include <gtest/gtest.h>

#include "scene/primitives/add.h"
#include "tests/scene/formats/temporary_file.h"

namespace brandung {
namespace {

/// Things of every kind, more than fit into one block.
const std::string text = R"({
    "camera": {"from": [0, 0, 9], "at": [0, 0, 0], "inside": ["air"]},
    "materials": [{"name": "grey", "type": "whitted"}, {"name": "air", "type": "whitted", "transmission": 1},
                  {"name": "glass", "type": "whitted", "transmission": 1}],
    "lights": [{"type": "point", "position": [0, 5, 0], "intensity": 10}],
    "groups": [{"name": "a", "objects": [{"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 1}]},
               {"name": "b", "objects": [{"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 2}]},
               {"name": "idle", "objects": [{"type": "sphere", "material": "grey", "center": [0, 0, 0], "radius": 3}]}],
    "objects": [
        {"type": "sphere", "material": "glass", "center": [0, 0, 0], "radius": 1},
        {"type": "cylinder", "material": "grey", "base": [2, 0, 0], "apex": [2, 1, 0], "radius": 1},
        {"type": "triangle_mesh", "material": "grey", "indices": [0,1,2, 2,3,4, 4,5,6, 6,7,8, 8,9,10, 10,11,12, 12,13,14, 14,15,16, 16,17,0, 1,3,5],
         "positions": [[0,0,0],[1,0,0],[1,1,0],[2,0,1],[2,1,1],[3,0,2],[3,1,2],[4,0,3],[4,1,3],[5,0,4],[5,1,4],[6,0,5],[6,1,5],[7,0,6],[7,1,6],
                       [8,0,7],[8,1,7],[9,0,8]]},
        {"type": "instance", "group": "a", "transform": {"translate": [0, 3, 0]}}, {"type": "instance", "group": "b"}
    ]
})";

std::uint64_t hash(const std::vector<std::string> &assignments = {}) {
    const Scene scene = read_text(text, assignments);
    return scene_hash(scene, compile(scene));
}

TEST(SceneHash, IsTheSameForEveryAccelerator) { EXPECT_EQ(hash({"accelerator=none"}), hash({"accelerator=wide_bvh"})); }

TEST(SceneHash, IgnoresGroupsWithoutInstances) { EXPECT_EQ(hash({"groups.2.objects.0.radius=4"}), hash()); }

TEST(SceneHash, IgnoresTheSettingsOfTheRender) { EXPECT_EQ(hash({"film.width=7", "film.exposure=3"}), hash()); }

class SeenChange : public testing::TestWithParam<const char *> {};

TEST_P(SeenChange, MakesAnotherHash) { EXPECT_NE(hash({GetParam()}), hash()); }

INSTANTIATE_TEST_SUITE_P(SceneHash, SeenChange,
                         testing::Values("objects.0.radius=1.0000001", "objects.1.apex=[2,2,0]", "objects.2.positions.17=[9,0,9]",
                                         "objects.0.material=grey", "materials.0.diffuse=0.4", "materials.2.eta=1.6", "lights.0.intensity=11",
                                         "background=0.1", "ambient=0.1", "camera.from=[0,0,8]", "camera.fov=44", "camera.type=panorama",
                                         "camera.inside=[]", "camera.inside=[\"glass\"]", "objects.3.transform.translate=[0,4,0]",
                                         "objects.3.group=b", "objects.3.material=air", "groups.0.objects.0.radius=1.5"));

TEST(SceneHash, SeesMotionsAsLongAsAShutterIsOpen) {
    const std::string keys = R"(objects.3.transform=[{"time": 0}, {"time": 1, "transform": {"translate": [0, 3, 0]}}])";
    const std::string faster = R"(objects.3.transform=[{"time": 0}, {"time": 1, "transform": {"translate": [0, 4, 0]}}])";
    const std::string open = "camera.shutter=[0,1]", eye = R"(camera.keys=[{"time": 0}, {"time": 1, "from": [1, 0, 9]}])";
    EXPECT_EQ(hash({keys, "camera.shutter=[1,1]"}), hash());
    EXPECT_EQ(hash({open}), hash()) << "nothing moves";
    EXPECT_NE(hash({keys, open}), hash({keys}));
    EXPECT_NE(hash({keys, open}), hash({faster, open}));
    EXPECT_NE(hash({keys, open}), hash({keys, "camera.shutter=[0,0.5]"}));
    EXPECT_EQ(hash({eye}), hash());
    EXPECT_NE(hash({eye, open}), hash());
}

TEST(SceneHash, SeesWhatOnlySomeCamerasHave) {
    const auto with_camera = [](const std::string &members) {
        return hash({R"(camera={"from": [0, 0, 9], "at": [0, 0, 0], "inside": ["air"], )" + members + "}"});
    };
    const std::string lens = R"("type": "thin_lens", "focus_distance": 3, )", fisheye = R"("type": "fisheye")";
    EXPECT_NE(with_camera(lens + R"("lens_radius": 1)"), with_camera(lens + R"("lens_radius": 2)"));
    EXPECT_NE(with_camera(lens + R"("lens_radius": 1)"), with_camera(lens + R"("lens_radius": 1, "blades": 5)"));
    EXPECT_NE(with_camera(fisheye), with_camera(fisheye + R"(, "mapping": "equisolid")"));
    EXPECT_NE(with_camera(R"("type": "orthographic", "height": 1)"), with_camera(R"("type": "orthographic", "height": 2)"));
}

/// The hash of the scene with a mesh of one triangle that has a picture, after a change.
template <class Change> std::uint64_t hash_with_picture(Change change) {
    Scene scene = read_text(text);
    scene.textures.push_back({"picture", {}, {2, 1, {Spectrum(1), Spectrum(0.5f)}, {}}});
    scene.materials[0].record.diffuse_texture = 1;
    MeshData mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, mesh.indices = {0, 1, 2};
    mesh.uvs = {{0, 0}, {1, 0}, {0, 1}}, mesh.colors = {Spectrum(1), Spectrum(1), Spectrum(1)};
    change(scene, mesh);
    add_triangle_mesh(scene, 0, std::move(mesh));
    return scene_hash(scene, compile(scene));
}

TEST(SceneHash, SeesPicturesAndWhatVerticesHave) {
    const std::uint64_t before = hash_with_picture([](Scene &, MeshData &) {});
    EXPECT_EQ(hash_with_picture([](Scene &scene, MeshData &) { scene.textures[0].file = "its copy"; }), before);
    EXPECT_NE(hash_with_picture([](Scene &scene, MeshData &) { scene.textures[0].picture.pixels[1].y = 0.25f; }), before);
    EXPECT_NE(hash_with_picture([](Scene &scene, MeshData &) { scene.textures[0].options.wrap = TextureWrap::clamp; }), before);
    EXPECT_NE(hash_with_picture([](Scene &scene, MeshData &) { scene.materials[0].record.diffuse_texture = 0; }), before);
    EXPECT_NE(hash_with_picture([](Scene &scene, MeshData &) { scene.background_texture = 1; }), before);
    EXPECT_NE(hash_with_picture([](Scene &scene, MeshData &) { scene.background_turn = 0.25f; }), before);
    EXPECT_NE(hash_with_picture([](Scene &, MeshData &mesh) { mesh.uvs[2].x = 0.5f; }), before);
    EXPECT_NE(hash_with_picture([](Scene &, MeshData &mesh) { mesh.colors[1].z = 0.5f; }), before);
}

}  // namespace
}  // namespace brandung
