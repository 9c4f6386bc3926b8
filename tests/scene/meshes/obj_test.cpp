#include <gtest/gtest.h>

#include <cmath>
#include <ctime>

#include "scene/image.h"

#include "tests/scene/meshes/mesh_folder.h"

namespace brandung {
namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

class Obj : public testing::Test {
protected:
    std::vector<MeshPart> read(const std::string &text) { return folder.read("mesh.obj", text); }
    std::string error(const std::string &text) { return folder.error("mesh.obj", text); }
    std::map<std::string, uint> &warnings() { return folder.scene.warnings; }

    MeshFolder folder;
};

TEST_F(Obj, APolygonBecomesTrianglesWithSharedVertices) {
    const auto parts = read(square + "f 1 2 3 4\nf -4 -3 -2\n");
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].mesh.positions.size(), 4u);
    EXPECT_EQ(parts[0].mesh.indices.size(), 9u);
    EXPECT_TRUE(parts[0].mesh.normals.empty());
    EXPECT_TRUE(parts[0].mesh.uvs.empty());
    const std::vector<vec3> corners = corners_of(parts[0]);
    EXPECT_EQ(corners[6], vec3(0, 0, 0));
    EXPECT_EQ(corners[8], vec3(1, 1, 0));
    EXPECT_TRUE(warnings().empty());
}

/// The area of an L of three unit squares; ears cut at the wrong corner would cover more.
TEST_F(Obj, AConcavePolygonIsCoveredOnce) {
    const auto parts = read("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n");
    double area = 0;
    const std::vector<vec3> corners = corners_of(parts.at(0));
    for (std::size_t i = 0; i < corners.size(); i += 3)
        area += 0.5 * glm::length(glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]));
    EXPECT_DOUBLE_EQ(area, 3);
}

TEST_F(Obj, VerticesDifferInAllThatTheyName) {
    const auto parts = read(square + "vt 0 0\nvt 0.25 0.5 7\nvn 0 0 2\nvn 0 3 4\nf 1/1/1 2/2/1 3/1/1\nf 1/1/1 3/1/2 4/-1/-2\n");
    ASSERT_EQ(parts.size(), 1u);
    const MeshData &mesh = parts[0].mesh;
    ASSERT_EQ(mesh.positions.size(), 5u);  // 3/1/1 and 3/1/2 are two
    ASSERT_EQ(mesh.normals.size(), 5u);
    EXPECT_EQ(mesh.uvs.at(1), vec2(0.25f, 0.5f));
    EXPECT_EQ(mesh.normals[0], vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[mesh.indices[4]], vec3(0, 0.6f, 0.8f));
    EXPECT_EQ(mesh.uvs[mesh.indices[5]], vec2(0.25f, 0.5f));
}

TEST_F(Obj, OnePartPerGroupAndMaterialInTheOrderOfTheFile) {
    folder.write("two.mtl", "newmtl red paint\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    const auto parts =
        read("mtllib two.mtl\n" + square +
             "usemtl red paint\ng a\nf 1 2 3\ng b\nf 1 2 3\nf 1 3 4\nusemtl blue # the sea\nf 1 2 4\nusemtl red paint\nf 2 3 4\no c\nf 1 2 3\n");
    ASSERT_EQ(parts.size(), 5u);
    std::vector<std::string> names;
    for (const MeshPart &part : parts) names.push_back(folder.scene.materials.at(part.material).name);
    EXPECT_EQ(names, (std::vector<std::string>{"red paint", "red paint", "blue # the sea", "red paint", "red paint"}));
    EXPECT_EQ(whitted_of(folder.scene.materials[parts[2].material].record).diffuse, Spectrum(0, 0, 1));
    EXPECT_EQ(parts[1].mesh.indices.size(), 6u);
    EXPECT_EQ(folder.scene.materials.size(), 2u);
    EXPECT_TRUE(warnings().empty());
}

TEST_F(Obj, LibrariesMayHaveBlanksInTheirNamesAndBeSeveral) {
    folder.write("my colours.mtl", "newmtl a\nKd 1 0 0\n");
    folder.write("other.mtl", "newmtl b\nKd 0 1 0\nnewmtl a\nKd 0 0 0\n");
    read("mtllib my colours.mtl\n" + square + "usemtl a\nf 1 2 3\n");
    EXPECT_EQ(whitted_of(folder.scene.materials.at(0).record).diffuse, Spectrum(1, 0, 0));
    read("mtllib none.mtl my\\ colours.mtl other.mtl\n" + square + "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n");
    EXPECT_EQ(whitted_of(folder.scene.materials.at(0).record).diffuse, Spectrum(1, 0, 0));
    EXPECT_EQ(whitted_of(folder.scene.materials.at(1).record).diffuse, Spectrum(0, 1, 0));
    EXPECT_EQ(warnings(), (std::map<std::string, uint>{{"material library \"none.mtl\" is not there", 1}}));
}

TEST_F(Obj, WhatHasNoMaterialIsGrey) {
    const auto parts = read(square + "f 1 2 3\nusemtl lost\nf 1 2 3\n");
    EXPECT_EQ(whitted_of(folder.scene.materials.at(parts.at(0).material).record).diffuse, Spectrum(0.6f));
    EXPECT_EQ(whitted_of(folder.scene.materials.at(parts.at(1).material).record).diffuse, Spectrum(0.6f));
    EXPECT_EQ(warnings().at("material that no library has: taken as grey"), 1u);
}

/// A roof: the mean of the two slopes along its ridge, as their angles there are equal; a flat edge below, since that group is another.
TEST_F(Obj, SmoothingGroupsShareNormals) {
    const std::string roof = "v -1 0 0\nv -1 0 1\nv 0 1 1\nv 0 1 0\nv 1 0 0\nv 1 0 1\n";
    const auto parts = read(roof + "s 1\nf 1 2 3 4\nf 4 3 6 5\ns 2\nf 1 2 3 4\ns off\nf 4 3 6 5\n");
    ASSERT_EQ(parts.size(), 2u);
    const MeshData &smooth = parts[0].mesh;
    ASSERT_EQ(smooth.normals.size(), smooth.positions.size());
    const float diagonal = std::sqrt(0.5f);
    for (std::size_t i = 0; i < smooth.positions.size(); ++i) {
        const vec3 expected =
            i >= 6 ? vec3(-diagonal, diagonal, 0) : vec3(smooth.positions[i].x * diagonal, smooth.positions[i].x == 0 ? 1 : diagonal, 0);
        EXPECT_LT(glm::length(smooth.normals[i] - expected), 1e-6f) << i;
    }
    EXPECT_TRUE(parts[1].mesh.normals.empty());
}

/// Two faces back to back: their normals cancel out, and each triangle keeps its own.
TEST_F(Obj, NormalsThatCancelOutAreReplaced) {
    const auto parts = read(square + "s 1\nf 1 2 3\nf 3 2 1\n");
    for (const vec3 &normal : parts.at(0).mesh.normals) EXPECT_NEAR(glm::length(normal), 1, 1e-6f);
}

TEST_F(Obj, LinesMayEndAndContinueInAnyWay) {
    const auto parts = read("# comment\r\nv 0 0 0\r\nv 1 0 \\\r\n0 # one\r\nv 1 1 0\r\n\r\n   \t\r\nf 1 2 \\\n 3");
    EXPECT_EQ(corners_of(parts.at(0)), (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
    EXPECT_TRUE(warnings().empty());
}

TEST_F(Obj, AByteOrderMarkIsNoWord) {
    const auto parts = read("\xef\xbb\xbf" + square + "f 1 2 3\n");
    EXPECT_EQ(corners_of(parts.at(0)), (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
    EXPECT_TRUE(warnings().empty());
}

TEST_F(Obj, LinesMayEndWithCarriageReturnsAlone) {
    folder.write("old.mtl", "newmtl a\rKd 1 0 0 # red\rKs 0\r");
    std::string text = "# comment\nmtllib old.mtl\n" + square + "usemtl a\nf 1 2 \\\n3\nf 1 2 5\n";
    std::replace(text.begin(), text.end(), '\n', '\r');
    EXPECT_EQ(error(text), "mesh.obj:10: face: there is no vertex 5; the file has 4 so far");
    text.resize(text.size() - 8);
    EXPECT_EQ(corners_of(read(text).at(0)), (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
    EXPECT_EQ(whitted_of(folder.scene.materials.at(0).record).diffuse, Spectrum(1, 0, 0));
    EXPECT_TRUE(warnings().empty());
}

/// 40000 triangles around one vertex, which has a normal or smoothing group for each, or one for all.
std::string fan(bool smooth, bool one_for_all) {
    constexpr int triangles = 40000;
    std::string text = "v 0 0 1\n";
    for (int i = 0; i <= triangles; ++i) text += "v " + std::to_string(std::cos(i)) + " " + std::to_string(std::sin(i)) + " 0\nvn 0 0 1\n";
    for (int i = 1; i <= triangles; ++i) {
        const std::string number = std::to_string(one_for_all ? 1 : i), corner = smooth ? "" : "//" + number;
        text += "s " + number + "\nf 1" + corner + " " + std::to_string(i + 1) + corner + " " + std::to_string(i + 2) + corner + "\n";
    }
    return text;
}

/// Where each is compared with all others at its position, 40000 take ten times as long as one.
TEST_F(Obj, ManyVerticesMayLieAtOnePosition) {
    const auto processor_time = [&](const std::string &text) {
        const std::clock_t begin = std::clock();
        read(text);
        return double(std::clock() - begin);
    };
    for (const bool smooth : {false, true}) {
        const std::string one = fan(smooth, true), each = fan(smooth, false);
        EXPECT_LT(processor_time(each), 5 * std::max(processor_time(one), processor_time(one))) << smooth;
    }
}

/// A circle of 20000 corners on one line.
TEST_F(Obj, LinesMayBeVeryLong) {
    std::string text, face = "f";
    for (int i = 0; i < 20000; ++i) {
        text += "v " + std::to_string(std::cos(i * 3.14159265e-4)) + " " + std::to_string(std::sin(i * 3.14159265e-4)) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    EXPECT_GT(read(text + face).at(0).mesh.indices.size(), 3u * 19000);
}

/// 0.5 in sRGB is 0.2140 in linear light; vertices before the first coloured one are white.
TEST_F(Obj, VerticesHaveColours) {
    const auto parts = read("v 0 0 0\nv 1 0 0 0.5 1 0\nv 1 1 0 0 0 1\nf 1 2 3\n");
    const std::vector<Spectrum> &colors = parts.at(0).mesh.colors;
    ASSERT_EQ(colors.size(), 3u);
    EXPECT_EQ(colors[0], Spectrum(1));
    EXPECT_NEAR(colors[1].x, 0.2140f, 1e-4f);
    EXPECT_EQ(colors[2], Spectrum(0, 0, 1));
    EXPECT_EQ(whitted_of(folder.scene.materials.at(parts[0].material).record).diffuse, Spectrum(1));
}

/// Some programs write 0 to 255.
TEST_F(Obj, ColoursBeyondOneAreCutAndCounted) {
    const auto parts = read("v 0 0 0 255 0 0\nv 1 0 0 0 -1 nan\nv 1 1 0 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(parts.at(0).mesh.colors, (std::vector<Spectrum>{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(warnings(), (std::map<std::string, uint>{{"vertex whose colour is not from 0 to 1: cut", 2}}));
}

TEST_F(Obj, MaterialsHaveTextures) {
    Picture picture{1, 1, {vec3(1)}, {}};
    write_picture(folder.write("my tex.exr", ""), picture, PictureStyle());
    folder.write("tex.mtl", "newmtl a\nmap_Kd my tex.exr\nmap_Ks .\\my tex.exr\nnewmtl b\nmap_Kd none.png\n");
    const auto parts = read("mtllib tex.mtl\n" + square + "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 1/1 2/1 3/1\n");
    EXPECT_EQ(folder.scene.materials.at(parts.at(0).material).record.diffuse_texture, 1u);
    EXPECT_NE(folder.scene.materials[0].record.specular_texture, 0u);
    EXPECT_EQ(folder.scene.materials[1].record.diffuse_texture, 0u);
    EXPECT_EQ(warnings().size(), 1u);
}

/// (0.5, 1) is scaled by (2, 4), then moved by (0.5, 0.25).
TEST_F(Obj, OptionsOfTexturesMoveTextureCoordinates) {
    write_picture(folder.write("t.exr", ""), {1, 1, {vec3(1)}, {}}, PictureStyle());
    folder.write("t.mtl",
                 "newmtl moved\nmap_Kd -s 2 4 -o 0.5 0.25 -clamp on t.exr\nnewmtl specular\nmap_Ks -s 2 4 -o 0.5 0.25 t.exr\nnewmtl both\n"
                 "map_Kd -s 2 4 -o 0.5 0.25 t.exr\nmap_Ks -s 3 t.exr\nnewmtl as_it_is\nmap_Kd t.exr\n");
    const auto parts = read("mtllib t.mtl\n" + square + "vt 0.5 1\nusemtl moved\nf 1/1 2/1 3/1\no second\nf 1/1 2/1 3/1\nusemtl specular\n" +
                            "f 1/1 2/1 3/1\nusemtl both\nf 1/1 2/1 3/1\nusemtl as_it_is\nf 1/1 2/1 3/1\n");
    ASSERT_EQ(parts.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(parts[i].mesh.uvs.at(0), i < 4 ? vec2(1.5f, 4.25f) : vec2(0.5f, 1)) << i;
    ASSERT_EQ(folder.scene.textures.size(), 2u);
    EXPECT_EQ(folder.scene.textures[0].options.wrap, TextureWrap::clamp);
    EXPECT_EQ(folder.scene.textures[1].options.wrap, TextureWrap::repeat);
    EXPECT_EQ(warnings(), (std::map<std::string, uint>{{"material whose textures have different scales or offsets: those of map_Kd count", 1}}));
}

TEST_F(Obj, WhatCannotBeSeenIsCounted) {
    const auto parts = read(square +
                            "v nan 0 0\nv 1.#IND 1.#INF -1.#IND\nv 1e30 0 0\nvn 0 0 0\nvn 0 0 1\n"
                            "f 1 2\nf 1\nf 1 2 5\nf 1 2 6\nf 7 2 3\np 1 2\nl 1 2\ncurv 0 1 1 2\nfoo bar\nf 1//1 2//2 3//2\nf 1//9 2//9 3//9\n"
                            "f 1/4 2/4 3/4\nf 1 2 1 2\n");
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].mesh.indices.size(), 9u);
    EXPECT_EQ(warnings(), (std::map<std::string, uint>{{"face with fewer than 3 corners: left out", 2},
                                                       {"face with a vertex that is no number or beyond 1e15: left out", 3},
                                                       {"points (p): left out", 1},
                                                       {"lines (l): left out", 1},
                                                       {"free-form curves and surfaces: left out", 1},
                                                       {"unknown statement: left out", 1},
                                                       {"face with a normal that has no direction: without", 1},
                                                       {"face with a normal that the file does not have: without", 1},
                                                       {"face with texture coordinates that the file does not have: without", 1},
                                                       {"polygon without area: left out", 1}}));
}

TEST_F(Obj, WhatMakesNoSenseIsAnErrorWithItsLine) {
    EXPECT_EQ(error("v 0 0 0\n\nv 1 0\n"), "mesh.obj:3: vertex: expected 3 coordinates, found 2");
    EXPECT_EQ(error("v 0 0 zero\n"), "mesh.obj:1: coordinate of a vertex: expected a number, found \"zero\"");
    EXPECT_EQ(error(square + "f 1 2 5\n"), "mesh.obj:5: face: there is no vertex 5; the file has 4 so far");
    EXPECT_EQ(error(square + "f 0 1 2\n"), "mesh.obj:5: face: there is no vertex 0; the file has 4 so far");
    EXPECT_EQ(error(square + "f -5 1 2\n"), "mesh.obj:5: face: there is no vertex -5; the file has 4 so far");
    EXPECT_EQ(error(square + "f 99999999999999999999 1 2\n"), "mesh.obj:5: face: expected v, v/vt, v//vn or v/vt/vn, found \"99999999999999999999\"");
    for (const char *corner : {"1/2/3/4", "1x", "/1", "1/x", "a"})
        EXPECT_EQ(error(square + "f 1 2 " + corner + "\n"),
                  "mesh.obj:5: face: expected v, v/vt, v//vn or v/vt/vn, found \"" + std::string(corner) + "\"");
    EXPECT_EQ(error("vn 1 0\n"), "mesh.obj:1: normal: expected 3 numbers on the line");
    EXPECT_EQ(error("vt\n"), "mesh.obj:1: texture coordinates: expected 1 to 3 numbers on the line");
    EXPECT_EQ(error("s smooth\n"), "mesh.obj:1: smoothing group: expected a number or off, found \"smooth\"");
    folder.write("bad.mtl", "newmtl a\n\nKd 1 -1 0\n");
    EXPECT_EQ(error("mtllib bad.mtl\n"), "bad.mtl:3: colour of a material: must not be negative, got -1");
}

TEST_F(Obj, ReadingIsReported) {
    std::string text = square;
    for (int i = 0; i < 40000; ++i) text += "f 1 2 3\n";
    const std::string file = folder.write("long.obj", text);
    Scene scene;
    std::vector<double> parts;
    read_mesh_file(file, "", scene, [&](const std::string &name, double part) {
        EXPECT_EQ(name, file);
        parts.push_back(part);
    });
    ASSERT_GE(parts.size(), 2u);
    EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
    EXPECT_GT(parts.back(), 0.5);
    EXPECT_LE(parts.back(), 1);
}

}  // namespace
}  // namespace brandung
