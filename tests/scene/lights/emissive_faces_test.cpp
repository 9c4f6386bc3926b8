#include "scene/lights/emissive_faces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brandung {
namespace {

TEST(EmissiveFaces, TwoTrianglesOfAParallelogramAreOneFace) {
    const std::vector<vec3> positions = {{1, 2, 3}, {3, 2, 3}, {3.5f, 4, 4}, {1.5f, 4, 4}};
    for (const std::vector<uint> &indices : {std::vector<uint>{0, 1, 2, 0, 2, 3}, {1, 2, 3, 3, 0, 1}, {2, 0, 3, 1, 0, 2}}) {
        const std::vector<EmissiveFace> faces = make_emissive_faces(positions, indices);
        ASSERT_EQ(faces.size(), 1u);
        const EmissiveFace &face = faces[0];
        EXPECT_EQ(face.folded, 0);
        EXPECT_EQ(face.kept, 1);
        EXPECT_NEAR(area_of(face), 2 * std::sqrt(5.0), 1e-6);  // sides (2, 0, 0) and (1/2, 2, 1)
        EXPECT_NEAR(glm::length(glm::cross(face.u, face.v)), area_of(face), 1e-6);
        EXPECT_NEAR(std::abs(glm::dot(face.normal, vec3(0, 1, -2))), std::sqrt(5.0f), 1e-6);
        const vec3 middle = face.corner + 0.5f * (face.u + face.v);
        EXPECT_NEAR(glm::distance(middle, vec3(2.25f, 3, 3.5f)), 0, 1e-6);
    }
}

TEST(EmissiveFaces, OtherNeighboursStayTriangles) {
    // A kite, a bent quadrilateral, two triangles that share no edge, and twice the same one.
    const std::vector<vec3> kite = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1.001f, 0}}, bent = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1e-3f}};
    for (const auto &positions : {kite, bent}) {
        const std::vector<EmissiveFace> faces = make_emissive_faces(positions, std::vector<uint>{0, 1, 2, 0, 2, 3});
        ASSERT_EQ(faces.size(), 2u);
        for (const EmissiveFace &face : faces) EXPECT_EQ(face.folded, 1);
    }
    EXPECT_EQ(make_emissive_faces(kite, std::vector<uint>{0, 1, 2, 0, 1, 2}).size(), 2u);
    EXPECT_EQ(make_emissive_faces({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, std::vector<uint>{0, 1, 2, 3, 4, 5}).size(),
              2u);
}

/// Together they would have one front.
TEST(EmissiveFaces, TrianglesThatFaceOppositeSidesStayTriangles) {
    const std::vector<vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const std::vector<EmissiveFace> faces = make_emissive_faces(square, std::vector<uint>{0, 1, 2, 0, 3, 2});
    ASSERT_EQ(faces.size(), 2u);
    EXPECT_EQ(faces[0].normal, vec3(0, 0, 1));
    EXPECT_EQ(faces[1].normal, vec3(0, 0, -1));
}

/// A grid of squares, in the order of a polygon's triangles, becomes the squares, not what lies across their sides.
TEST(EmissiveFaces, AGridBecomesItsCells) {
    std::vector<vec3> positions;
    std::vector<uint> indices;
    const uint n = 16;
    for (uint j = 0; j <= n; ++j)
        for (uint i = 0; i <= n; ++i) positions.push_back({float(i) / n, 7, float(j) / n});
    for (uint j = 0; j < n; ++j)
        for (uint i = 0; i < n; ++i) {
            const uint a = j * (n + 1) + i, b = a + n + 1;
            indices.insert(indices.end(), {a, a + 1, b + 1, a, b + 1, b});
        }
    const std::vector<EmissiveFace> faces = make_emissive_faces(positions, indices);
    ASSERT_EQ(faces.size(), n * n);
    double area = 0;
    for (const EmissiveFace &face : faces) {
        EXPECT_NEAR(std::abs(glm::dot(face.u, face.v)), 0, 1e-7);
        area += area_of(face);
    }
    EXPECT_NEAR(area, 1, 1e-6);
}

}  // namespace
}  // namespace brandung
