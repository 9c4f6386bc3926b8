#include "scene/lights/emissive_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace brandung {
namespace {

/// How often entries of the table choose each face, of all choices.
std::vector<double> chances(const std::vector<EmissiveFace> &faces) {
    std::vector<double> result(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        result[i] += faces[i].kept / double(faces.size());
        result[faces[i].alias] += (1 - double(faces[i].kept)) / double(faces.size());
    }
    return result;
}

TEST(EmissiveFaces, TwoTrianglesOfAParallelogramAreOneFace) {
    const std::vector<vec3> positions = {{1, 2, 3}, {3, 2, 3}, {3.5f, 4, 4}, {1.5f, 4, 4}};
    for (const std::vector<uint> &indices : {std::vector<uint>{0, 1, 2, 0, 2, 3}, {1, 2, 3, 3, 0, 1}, {2, 0, 3, 1, 0, 2}}) {
        const EmissiveFaces result = make_emissive_faces(positions, indices);
        ASSERT_EQ(result.faces.size(), 1u);
        const EmissiveFace &face = result.faces[0];
        EXPECT_EQ(face.folded, 0);
        EXPECT_EQ(face.kept, 1);
        EXPECT_NEAR(result.area, 2 * std::sqrt(5.0), 1e-6);  // sides (2, 0, 0) and (1/2, 2, 1)
        EXPECT_NEAR(glm::length(glm::cross(face.u, face.v)), result.area, 1e-6);
        EXPECT_NEAR(std::abs(glm::dot(face.normal, vec3(0, 1, -2))), std::sqrt(5.0f), 1e-6);
        const vec3 middle = face.corner + 0.5f * (face.u + face.v);
        EXPECT_NEAR(glm::distance(middle, vec3(2.25f, 3, 3.5f)), 0, 1e-6);
    }
}

TEST(EmissiveFaces, OtherNeighboursStayTriangles) {
    // A kite, a bent quadrilateral, two triangles that share no edge, and twice the same one.
    const std::vector<vec3> kite = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1.001f, 0}}, bent = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1e-3f}};
    for (const auto &positions : {kite, bent}) {
        const EmissiveFaces result = make_emissive_faces(positions, std::vector<uint>{0, 1, 2, 0, 2, 3});
        ASSERT_EQ(result.faces.size(), 2u);
        for (const EmissiveFace &face : result.faces) EXPECT_EQ(face.folded, 1);
    }
    EXPECT_EQ(make_emissive_faces(kite, std::vector<uint>{0, 1, 2, 0, 1, 2}).faces.size(), 2u);
    EXPECT_EQ(
        make_emissive_faces({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, std::vector<uint>{0, 1, 2, 3, 4, 5}).faces.size(),
        2u);
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
    const EmissiveFaces result = make_emissive_faces(positions, indices);
    ASSERT_EQ(result.faces.size(), n * n);
    EXPECT_NEAR(result.area, 1, 1e-6);
    for (const EmissiveFace &face : result.faces) EXPECT_NEAR(std::abs(glm::dot(face.u, face.v)), 0, 1e-7);
}

/// 50,000 triangles of sizes over three decades.
TEST(EmissiveFaces, TheTableChoosesEachFaceByItsArea) {
    std::mt19937 engine(3);
    std::uniform_real_distribution<float> place(-1, 1), decades(-3, 0);
    std::vector<vec3> positions;
    std::vector<uint> indices;
    for (uint i = 0; i < 50000; ++i) {
        const float size = std::pow(10.0f, decades(engine));
        const vec3 corner(place(engine), place(engine), place(engine));
        for (uint k = 0; k < 3; ++k) {
            indices.push_back(uint(positions.size()));
            positions.push_back(corner + size * vec3(place(engine), place(engine), place(engine)));
        }
    }
    const EmissiveFaces result = make_emissive_faces(positions, indices);
    ASSERT_EQ(result.faces.size(), 50000u);
    const std::vector<double> chance = chances(result.faces);
    double sum = 0;
    for (std::size_t i = 0; i < result.faces.size(); ++i) {
        const double area = 0.5 * double(glm::length(glm::cross(glm::dvec3(result.faces[i].u), glm::dvec3(result.faces[i].v))));
        // The probabilities are floats: a face may be the alias of some hundred, each off by 2^-25 / 50000.
        ASSERT_NEAR(chance[i], area / result.area, 1e-9) << i;
        sum += chance[i];
        ASSERT_GE(result.faces[i].kept, 0);
        ASSERT_LE(result.faces[i].kept, 1);
    }
    EXPECT_NEAR(sum, 1, 1e-9);
}

}  // namespace
}  // namespace brandung
