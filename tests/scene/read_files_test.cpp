/// What scenes have read, and where what is doubtful in it comes from.
#include <gtest/gtest.h>

#include <algorithm>

#include "scene/compile.h"
#include "tests/scene/meshes/mesh_folder.h"

namespace brandung {
namespace {

/// A picture that is not there has not been read, and may be written.
TEST(ReadFiles, HaveNoneThatIsMissing) {
    const MeshFolder folder;
    folder.write("a.mtl", "newmtl m\nmap_Kd missing.png\n");
    const std::string mesh = folder.write("a.obj", "mtllib a.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    const Scene scene = read_scene(mesh, {});
    const auto has = [&](const std::string &name) {
        return std::any_of(scene.files.begin(), scene.files.end(), [&](const std::string &file) { return file.ends_with(name); });
    };
    EXPECT_TRUE(has("a.mtl"));
    EXPECT_FALSE(has("missing.png"));
    EXPECT_TRUE(scene.warnings.size() > 0);
}

/// Of two libraries, of which the first is missing: the OBJ names it, the second one's own faults are its own.
TEST(ReadFiles, WarningsOfLibrariesAreWhereTheyAreNamedOrInThem) {
    const MeshFolder folder;
    folder.write("there.mtl", "newmtl m\nKd red\n");
    const std::string mesh = folder.write("a.obj", "v 0 0 0\nmtllib missing.mtl there.mtl\nusemtl m\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    const Scene scene = read_scene(mesh, {});
    std::string missing, others;
    for (const auto &[text, place] : scene.warning_places) (text.find("missing.mtl") != std::string::npos ? missing : others) += place;
    EXPECT_EQ(missing, mesh + ":2");
    EXPECT_TRUE(others.ends_with("there.mtl:2")) << others;
}

/// Of statements it is their line, of what a material means that of its name, of a material that is in no library that where it is first used.
TEST(ReadFiles, WarningsOfMaterialsHaveTheirLines) {
    const MeshFolder folder;
    const std::string library = folder.write("a.mtl", "newmtl m\nKd 1 1 1\nfoo\n\nnewmtl n\nd 0.5\nTr 0.25\nmap_Kd missing.png\nfoo\n"),
                      mesh = folder.write("a.obj",
                                          "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\nusemtl n\nf 1 2 3\nusemtl o\nf 1 2 3\n"
                                          "usemtl m\nusemtl o\nf 3 2 1\n");
    const Scene scene = read_scene(mesh, {});
    const std::map<std::string, std::string> expected = {
        {"unknown material statement: not used", library + ":3"},
        {"material whose d and Tr contradict each other: d counts", library + ":5"},
        {"texture left out: " + library.substr(0, library.size() - 5) + "missing.png: no such file", library + ":5"},
        {"material that no library has: taken as grey", mesh + ":9"}};
    EXPECT_EQ(scene.warning_places, expected);
    EXPECT_EQ(scene.warnings.at("unknown material statement: not used"), 2u);
}

constexpr const char *const opaque_shadows = "transparent objects cast opaque shadows: --shadows filtered lets light through them",
                            *const no_uvs = "triangle with a texture, but without texture coordinates: has the colour at (0, 0)";

std::string place_when_compiled(const std::string &file, const std::string &warning) {
    const CompiledScene compiled = compile(read_scene(file, {}));
    const auto place = compiled.warning_places.find(warning);
    return place == compiled.warning_places.end() ? "none" : place->second;
}

/// The first transparent material that something has; the first object, or of what has no number the material.
TEST(ReadFiles, WarningsOfCompilationHavePlacesToo) {
    const MeshFolder folder;
    const std::string library = folder.write("a.mtl", "newmtl m\nKd 1 1 1\nnewmtl n\nd 0.5\nmap_Kd a.pfm\n"),
                      mesh = folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\nusemtl n\nf 1 2 3\n"),
                      ply = folder.write(
                          "a.ply",
                          "ply\nformat ascii 1.0\ncomment TextureFile a.pfm\nelement vertex 3\nproperty float x\nproperty float y\n"
                          "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    folder.write("a.pfm", std::string("PF\n1 1\n-1.0\n") + std::string(12, '\0'));
    EXPECT_EQ(place_when_compiled(mesh, opaque_shadows), library + ":3");
    EXPECT_EQ(place_when_compiled(mesh, no_uvs), library + ":3");
    EXPECT_EQ(place_when_compiled(ply, no_uvs), ply);
    const std::string scene = folder.write("scene.json", R"({"camera": {"from": [0, 0, 5], "at": [0, 0, 0]}, "materials": [
{"name": "unused", "type": "whitted", "transmission": 1},
{"name": "glass", "type": "whitted", "diffuse": {"texture": "a.pfm"}, "transmission": 1}],
"lights": [{"type": "point", "position": [1, 2, 3], "intensity": 10}],
"groups": [{"name": "unused", "objects": []}, {"name": "g", "objects": [{"type": "sphere", "material": "glass", "center": [0, 0, 0], "radius": 1},
{"type": "polygon", "material": "glass", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}]}],
"objects": [{"type": "instance", "group": "g"}]})");
    EXPECT_EQ(place_when_compiled(scene, opaque_shadows), scene + ":3: /materials/1");
    EXPECT_EQ(place_when_compiled(scene, no_uvs), scene + ":6: /groups/1/objects/1");
    const std::string nff = folder.write("a.nff",
                                         "v\nfrom 0 0 4\nat 0 0 0\nup 0 1 0\nangle 40\nresolution 8 8\nl 1 1 1\nf 1 1 1 1 0 0 0 1\ns 0 0 0 1\n"
                                         "f 1 1 1 1 0 0 0.5 1\ns 0 0 0 2\n");
    Scene spheres = read_scene(nff, {});
    spheres.integrator.shadows_unsaid = true;
    EXPECT_EQ(compile(spheres).warning_places.at(opaque_shadows), nff + ":10");
}

/// A scene that was made by other means, or whose file has gone, is compiled all the same.
TEST(ReadFiles, PlacesThatCannotBeLookedUpAreEmpty) {
    const MeshFolder folder;
    const std::string file = folder.write("scene.json", R"({"camera": {"from": [0, 0, 5], "at": [0, 0, 0]}, "ambient": 1,
"materials": [{"name": "glass", "type": "whitted", "transmission": 1}], "lights": [{"type": "point", "position": [1, 2, 3], "intensity": 10}],
"objects": [{"type": "sphere", "material": "glass", "center": [0, 0, 0], "radius": 1}]})");
    const Scene scene = read_scene(file, {});
    std::filesystem::remove(file);
    EXPECT_EQ(compile(scene).warning_places.at(opaque_shadows), "");
}

}  // namespace
}  // namespace brandung
