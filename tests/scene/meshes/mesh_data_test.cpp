/// Files that others made: how many triangles each gives and what is said about it.
#include <gtest/gtest.h>

#include <filesystem>

#include "scene/error.h"
#include "scene/formats/format.h"

namespace brandung {
namespace {

namespace fs = std::filesystem;

struct MeshFile {
    const char *name;
    std::size_t triangles;
    uint warnings;           ///< how often something was left out or doubtful
    const char *error = "";  ///< behind the file's name; empty: it is read
};

std::ostream &operator<<(std::ostream &out, const MeshFile &file) { return out << file.name; }

class MeshFiles : public testing::TestWithParam<MeshFile> {};

TEST_P(MeshFiles, GiveTheirTrianglesOrSayWhyNot) {
    const MeshFile &expected = GetParam();
    const fs::path file = fs::path(BRANDUNG_DATA) / "meshes" / expected.name;
    if (std::string(BRANDUNG_DATA).empty() || !fs::exists(file)) GTEST_SKIP() << "no " << file;
    std::size_t triangles = 0;
    uint warnings = 0;
    std::string error;
    try {
        const Scene scene = read_scene(file.string());
        for (const auto &shape : scene.shapes) triangles += shape->count();
        for (const auto &[text, count] : scene.warnings) warnings += count;
        EXPECT_EQ(scene.cameras.size(), 1u);
    } catch (const SceneError &fault) {
        error = std::string(fault.what()).substr(file.string().size());
    }
    EXPECT_EQ(triangles, expected.triangles);
    EXPECT_EQ(warnings, expected.warnings);
    EXPECT_EQ(error, expected.error);
}

INSTANTIATE_TEST_SUITE_P(
    Data, MeshFiles,
    testing::Values(
        MeshFile{"obj-parser-cases/catmark_torus_creases0.obj", 64, 40}, MeshFile{"obj-parser-cases/colorspace-issue-184.obj", 1, 4},
        MeshFile{"obj-parser-cases/cornell_box.obj", 36, 0}, MeshFile{"obj-parser-cases/cornell_box_multimaterial.obj", 36, 0},
        MeshFile{"obj-parser-cases/cube-vertex-w-component.obj", 12, 0}, MeshFile{"obj-parser-cases/cube-vertexcol.obj", 12, 0},
        MeshFile{"obj-parser-cases/cube.obj", 12, 0},
        MeshFile{"obj-parser-cases/invalid-face-definition.obj", 0, 0,
                 ": has no faces with an area, so that nothing of it can be seen; face with fewer than 3 corners: left out (2)"},
        MeshFile{"obj-parser-cases/invalid-relative-texture-index.obj", 0, 0, ":2: face: there is no vertex 1; the file has 0 so far"},
        MeshFile{"obj-parser-cases/invalid-relative-vertex-index.obj", 0, 0, ":1: face: there is no vertex -4; the file has 0 so far"},
        MeshFile{"obj-parser-cases/issue-138.obj", 12, 0},
        MeshFile{"obj-parser-cases/issue-140-zero-face-idx.obj", 0, 0, ":16: face: there is no vertex 0; the file has 4 so far"},
        MeshFile{"obj-parser-cases/issue-161-inconsistent-f.obj", 12, 1}, MeshFile{"obj-parser-cases/issue-162-smoothing-group.obj", 12, 0},
        MeshFile{"obj-parser-cases/issue-235-usemtl-then-o.obj", 2, 0}, MeshFile{"obj-parser-cases/issue-244-mtl-searchpaths.obj", 2, 3},
        MeshFile{"obj-parser-cases/issue-246-usemtl-whitespace.obj", 1, 0}, MeshFile{"obj-parser-cases/issue-248-texres-texopt.obj", 12, 1},
        MeshFile{"obj-parser-cases/issue-295-trianguation-failure.obj", 28, 0}, MeshFile{"obj-parser-cases/issue-319-002.obj", 13, 0},
        MeshFile{"obj-parser-cases/issue-319-003.obj", 8, 0}, MeshFile{"obj-parser-cases/issue-330.obj", 3, 1},
        MeshFile{"obj-parser-cases/issue-356-leading-spaces-newmtl.obj", 0, 0, ": has no faces with an area, so that nothing of it can be seen"},
        MeshFile{"obj-parser-cases/issue-92.obj", 1, 1}, MeshFile{"obj-parser-cases/issue-95-2.obj", 1, 1},
        MeshFile{"obj-parser-cases/issue-95.obj", 1, 1}, MeshFile{"obj-parser-cases/leading-decimal-dot-issue-201.obj", 1, 1},
        MeshFile{"obj-parser-cases/leading-zero-in-exponent-notation-issue-210.obj", 1, 1},
        MeshFile{"obj-parser-cases/line-prim.obj", 0, 0, ": has no faces with an area, so that nothing of it can be seen; lines (l): left out (2)"},
        MeshFile{"obj-parser-cases/map-bump.obj", 400, 1}, MeshFile{"obj-parser-cases/missing_material_file.obj", 36, 4},
        MeshFile{"obj-parser-cases/mtl filename with whitespace issue46.obj", 12, 2},
        MeshFile{"obj-parser-cases/mtllib-multiple-files-issue-112.obj", 1, 3}, MeshFile{"obj-parser-cases/no_material.obj", 36, 0},
        MeshFile{"obj-parser-cases/norm-texopt.obj", 1, 2}, MeshFile{"obj-parser-cases/pbr-mat-ext.obj", 2, 10},
        MeshFile{"obj-parser-cases/points-prim.obj", 0, 0,
                 ": has no faces with an area, so that nothing of it can be seen; points (p): left out (1)"},
        MeshFile{"obj-parser-cases/refl.obj", 12, 1}, MeshFile{"obj-parser-cases/skin-weight.obj", 12, 0},
        MeshFile{"obj-parser-cases/smoothing-group-two-squares.obj", 3, 2}, MeshFile{"obj-parser-cases/smoothing-normal.obj", 6, 0},
        MeshFile{"obj-parser-cases/test-nan.obj", 34, 1}, MeshFile{"obj-parser-cases/texture-filename-with-whitespace.obj", 12, 2},
        MeshFile{"obj-parser-cases/texture-options-issue-85.obj", 1, 13}, MeshFile{"obj-parser-cases/tr-and-d-issue-43.obj", 400, 4},
        MeshFile{"obj-parser-cases/usemtl-issue-104.obj", 6, 0}, MeshFile{"obj-parser-cases/usemtl-issue-68.obj", 400, 0},
        MeshFile{"stanford-bunny.obj", 69451, 0}, MeshFile{"teapot-spd-s8.obj", 4160, 3}, MeshFile{"stanford-dragon-res3.ply", 47794, 0},
        MeshFile{"mcguire-cornell-box/CornellBox-Empty-CO.obj", 12, 0}, MeshFile{"mcguire-cornell-box/CornellBox-Empty-RG.obj", 12, 0},
        MeshFile{"mcguire-cornell-box/CornellBox-Empty-Squashed.obj", 12, 0}, MeshFile{"mcguire-cornell-box/CornellBox-Empty-White.obj", 12, 0},
        MeshFile{"mcguire-cornell-box/CornellBox-Glossy.obj", 1112, 0}, MeshFile{"mcguire-cornell-box/CornellBox-Mirror.obj", 36, 0},
        MeshFile{"mcguire-cornell-box/CornellBox-Original.obj", 36, 0}, MeshFile{"mcguire-cornell-box/CornellBox-Sphere.obj", 2188, 1},
        MeshFile{"mcguire-cornell-box/CornellBox-Water.obj", 7088, 2}, MeshFile{"mcguire-cornell-box/water.obj", 4900, 2},
        MeshFile{"spot/spot_triangulated.obj", 5856, 0}));

}  // namespace
}  // namespace brandung
