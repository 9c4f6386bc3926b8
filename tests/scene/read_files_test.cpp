/// What scenes have read, and where what is doubtful in it comes from.
#include <gtest/gtest.h>

#include <algorithm>

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
    EXPECT_NE(others.find("there.mtl"), std::string::npos);
}

}  // namespace
}  // namespace brandung
