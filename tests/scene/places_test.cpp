/// Where shapes are in their files: only for those who ask.
#include <gtest/gtest.h>

#include "tests/scene/formats/nff_text.h"
#include "tests/scene/meshes/mesh_folder.h"

namespace brandung {
namespace {

/// By shape and primitive, as it is told, behind the name of the file.
std::vector<std::vector<std::string>> places_in(const std::string &file) {
    const Scene scene = read_scene(file, {.keep_places = true});
    EXPECT_FALSE(read_scene(file).places);
    std::vector<std::vector<std::string>> all;
    for (const auto &shape : scene.shapes) {
        const PlaceInFile &place = scene.places.value().at(shape.get());
        EXPECT_EQ(place.before.substr(0, file.size()), file);
        EXPECT_EQ(place.numbers.size(), shape->count());
        all.emplace_back();
        for (const uint number : place.numbers) all.back().push_back(place.before.substr(file.size()) + std::to_string(number));
    }
    return all;
}

using Places = std::vector<std::vector<std::string>>;

/// A square is two triangles of one line; the triangle of line 8 has no area. Line 10 begins another mesh, and goes on to line 11.
TEST(ShapePlaces, OfObjAreTheLinesOfFaces) {
    const MeshFolder folder;
    const std::string file = folder.write("a.obj",
                                          "# lines count from 1\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                          "f 1 2 3 4\nf 1 2 3\nf 1 2 2\ng other\nf 2 3 \\\n4\nf 1 3 4\n");
    EXPECT_EQ(places_in(file), (Places{{":6", ":6", ":7"}, {":10", ":12"}}));
}

/// The second face of three has no area.
TEST(ShapePlaces, OfPlyAreNumbersOfFaces) {
    const MeshFolder folder;
    const std::string file = folder.write("a.ply",
                                          "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                                          "element face 3\nproperty list uchar int vertex_indices\nend_header\n"
                                          "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 1\n3 0 2 3\n");
    EXPECT_EQ(places_in(file), (Places{{": face 0", ": face 0", ": face 2"}}));
}

/// Of consecutive polygons one mesh is made, which ends where something else begins.
TEST(ShapePlaces, OfNffAreTheLinesOfObjects) {
    const NffFile file(nff_viewpoint +
                       "s 0 0 0 1\np 3\n0 0 0\n1 0 0\n0 1 0\np 4 0 0 0 1 0 0 1 1 0 0 1 0\ns 1 1 1 0\n"
                       "l 1 2 3\nc\n0 0 0 1\n0 1 0 1\n");
    EXPECT_EQ(places_in(file.path()), (Places{{":8"}, {":9", ":13", ":13"}, {":16"}}));
}

TEST(ShapePlaces, OfMeshesOfNativeScenesAreThoseInTheirFiles) {
    const MeshFolder folder;
    const std::string mesh = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    for (const std::string material : {"", R"("material": "m", )"}) {
        const std::string file =
            folder.write("scene.json", R"({"camera": {"from": [0, 0, 9], "at": [0, 0, 0]}, "materials": [{"name": "m", "type": "whitted"}],
                "objects": [{"type": "sphere", "material": "m", "center": [0, 0, 0], "radius": 1}, {"type": "mesh", )" +
                                           material + R"("file": "a.obj"}]})");
        const Scene scene = read_scene(file, {.keep_places = true});
        ASSERT_EQ(scene.shapes.size(), 2u);
        EXPECT_FALSE(scene.places->contains(scene.shapes[0].get())) << "the scene's own objects have numbers";
        EXPECT_EQ(scene.places->at(scene.shapes[1].get()).before, mesh + ":");
        EXPECT_EQ(scene.places->at(scene.shapes[1].get()).numbers, std::vector<uint>{4});
    }
}

}  // namespace
}  // namespace brandung
