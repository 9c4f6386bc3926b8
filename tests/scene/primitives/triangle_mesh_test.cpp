#include <gtest/gtest.h>

#include <cstring>

#include "tests/scene/primitives/read_shape.h"

namespace brandung {
namespace {

/// Two triangles of a square.
MeshData square() { return {.positions = {{0, 0, 1}, {1, 0, 2}, {1, 1, 3}, {0, 1, 4}}, .normals = {}, .uvs = {}, .indices = {0, 1, 2, 0, 2, 3}}; }

MeshData smooth_square() {
    MeshData mesh = square();
    mesh.normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
    return mesh;
}

template <class View> View shading_of(const Shape &shape, std::size_t i, SharedTables &tables) {
    ShadingRecord record{};
    shape.write_shading(i, record.words, tables);
    View view;
    std::memcpy(&view, record.words, sizeof view);
    return view;
}

TEST(TriangleMeshShape, ListsNameItsKinds) {
    const auto flat = make_triangle_mesh(3, square()), smooth = make_triangle_mesh(4, smooth_square());
    EXPECT_EQ(&flat->kind(), primitive_kinds()[1]);
    EXPECT_EQ(&smooth->kind(), primitive_kinds()[2]);
    EXPECT_STREQ(flat->kind().name, "triangle");
    EXPECT_STREQ(smooth->kind().name, "smooth_triangle");
    EXPECT_EQ(flat->kind().block_bytes, sizeof(TriangleBlock));
    EXPECT_EQ(smooth->kind().block_bytes, sizeof(SmoothTriangleBlock));
    EXPECT_EQ(flat->count(), 2u);
    EXPECT_EQ(smooth->material, 4u);
}

TEST(TriangleMeshShape, WritesItsLanesAndBounds) {
    const auto mesh = make_triangle_mesh(0, square());
    TriangleBlock block{};
    mesh->write_lane(1, 3, reinterpret_cast<std::byte *>(&block));
    EXPECT_EQ(vec3(block.a[0][3], block.a[1][3], block.a[2][3]), vec3(0, 0, 1));
    EXPECT_EQ(vec3(block.b[0][3], block.b[1][3], block.b[2][3]), vec3(1, 1, 3));
    EXPECT_EQ(vec3(block.c[0][3], block.c[1][3], block.c[2][3]), vec3(0, 1, 4));
    EXPECT_EQ(block.b[0][2], 0);
    EXPECT_EQ(mesh->bounds(1).low, vec3(0, 0, 1));
    EXPECT_EQ(mesh->bounds(1).high, vec3(1, 1, 4));
}

TEST(TriangleMeshShape, WritesItsShadingWords) {
    SharedTables tables;
    const auto flat = make_triangle_mesh(0, square());
    const auto view = shading_of<TriangleShading>(*flat, 1, tables);
    EXPECT_EQ(view.a, vec3(0, 0, 1));
    EXPECT_EQ(view.b, vec3(1, 1, 3));
    EXPECT_EQ(view.c, vec3(0, 1, 4));
    EXPECT_TRUE(tables.vertex_normals.empty());

    const auto smooth = make_triangle_mesh(0, smooth_square());
    shading_of<SmoothTriangleShading>(*smooth, 0, tables);
    const auto second = shading_of<SmoothTriangleShading>(*smooth, 1, tables);
    EXPECT_EQ(second.flat.c, vec3(0, 1, 4));
    EXPECT_EQ(second.normals, 1u);
    ASSERT_EQ(tables.vertex_normals.size(), 2u);
    EXPECT_EQ(tables.vertex_normals[1].a, vec3(0, 0, 1));
    EXPECT_EQ(tables.vertex_normals[1].b, vec3(1, 0, 0));
    EXPECT_EQ(tables.vertex_normals[1].c, vec3(0, 0, -1));
}

TEST(TriangleMeshShape, TrianglesWithoutAreaAreDroppedAndCounted) {
    const Scene scene =
        read_shape(R"({"type": "triangle_mesh", "positions": [[0, 0, 0], [1, 1, 1], [2, 2, 2], [0, 1, 0], [1e-25, 0, 0], [0, 1e-25, 0]],
        "indices": [0, 1, 2, 0, 1, 3, 0, 0, 3, 0, 4, 5]})");
    ASSERT_EQ(scene.shapes.size(), 1u);
    EXPECT_EQ(scene.shapes[0]->count(), 1u);
    EXPECT_EQ(scene.shapes[0]->bounds(0).high, vec3(1, 1, 1));
    EXPECT_EQ(scene.warnings.at("triangle without area: left out"), 3u);

    const Scene nothing = read_shape(R"({"type": "triangle_mesh", "positions": [[0, 0, 0], [1, 1, 1], [2, 2, 2]], "indices": [0, 1, 2]})");
    EXPECT_TRUE(nothing.shapes.empty());
    EXPECT_EQ(nothing.warnings.at("triangle without area: left out"), 1u);
}

TEST(TriangleMeshShape, NormalsAreScaledToUnitLength) {
    const Scene scene = read_shape(R"({"type": "triangle_mesh", "positions": [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
        "normals": [[0, 0, 2], [0, 3, 4], [1e-15, 0, 0]], "uvs": [[0, 0], [1, 0], [0, 1]], "indices": [0, 1, 2]})");
    SharedTables tables;
    shading_of<SmoothTriangleShading>(*scene.shapes.at(0), 0, tables);
    EXPECT_EQ(tables.vertex_normals.at(0).a, vec3(0, 0, 1));
    EXPECT_EQ(tables.vertex_normals.at(0).b, vec3(0, 0.6f, 0.8f));
    EXPECT_EQ(tables.vertex_normals.at(0).c, vec3(1, 0, 0));
}

TEST(TriangleMeshShape, BadMeshesAreRefused) {
    const auto error = [](const std::string &rest) {
        return error_of_shape(R"({"type": "triangle_mesh", "positions": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], )" + rest + "}");
    };
    EXPECT_EQ(error(R"("indices": [0, 1, 2])"), "");
    EXPECT_NE(error(R"("indices": [0, 1, 3])").find("/indices/2: must be below the number of vertices, 3, got 3"), std::string::npos);
    EXPECT_NE(error(R"("indices": [0, 1])").find("must be three per triangle, got 2"), std::string::npos);
    EXPECT_NE(error(R"("indices": [])").find("must be three per triangle, got 0"), std::string::npos);
    EXPECT_NE(error(R"("indices": [0, 1, -1])"), "");
    EXPECT_NE(error(R"("indices": [0, 1, 2], "normals": [[0, 0, 1]])").find("must be one per vertex, got 1 for 3 vertices"), std::string::npos);
    EXPECT_NE(error(R"("indices": [0, 1, 2], "normals": [[0, 0, 1], [0, 0, 1], [0, 0, 0]])").find("must not be zero"), std::string::npos);
    EXPECT_NE(error(R"("indices": [0, 1, 2], "uvs": [[0, 0]])").find("must be one pair per vertex"), std::string::npos);
    EXPECT_NE(error(R"("index": [0, 1, 2])").find("\"indices\" is missing"), std::string::npos);
    EXPECT_NE(error_of_shape(R"({"type": "triangle_mesh", "indices": [0, 1, 2]})").find("\"positions\" is missing"), std::string::npos);
    EXPECT_NE(error_of_shape(R"({"type": "triangle_mesh", "positions": [], "indices": [0, 1, 2]})").find("/positions: must have vertices"),
              std::string::npos);
    EXPECT_NE(error_of_shape(R"({"type": "polygon", "positions": []})").find("\"vertices\" is missing"), std::string::npos);
}

TEST(PolygonShape, BecomesAMesh) {
    const Scene scene = read_shape(R"({"type": "polygon", "vertices": [[0, 0, 0], [2, 1, 0], [0, 2, 0], [0.5, 1, 0]]})");
    ASSERT_EQ(scene.shapes.size(), 1u);
    EXPECT_STREQ(scene.shapes[0]->kind().name, "triangle");
    EXPECT_EQ(scene.shapes[0]->count(), 2u);
    EXPECT_EQ(scene.shapes[0]->material, 7u);
    const Scene smooth =
        read_shape(R"({"type": "polygon", "vertices": [[0, 0, 0], [2, 1, 0], [0, 2, 0]], "normals": [[0, 0, 1], [0, 0, 1], [0, 0, 1]]})");
    EXPECT_STREQ(smooth.shapes.at(0)->kind().name, "smooth_triangle");
}

TEST(PolygonShape, BadPolygonsAreRefusedAndFlatOnesCounted) {
    EXPECT_NE(error_of_shape(R"({"type": "polygon", "vertices": [[0, 0, 0], [2, 1, 0]]})").find("must be at least 3 points, got 2"),
              std::string::npos);
    EXPECT_NE(error_of_shape(R"({"type": "polygon"})"), "");
    const Scene scene = read_shape(R"({"type": "polygon", "vertices": [[0, 0, 0], [1, 0, 0], [3, 0, 0], [2, 0, 0]]})");
    EXPECT_TRUE(scene.shapes.empty());
    EXPECT_EQ(scene.warnings.at("polygon without area: left out"), 1u);
}

}  // namespace
}  // namespace brandung
