#include "scene/lights/emissive_cells.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <span>

#include "scene/lights/emissive_faces.h"

namespace brandung {
namespace {

std::span<const EmissiveFace> faces_of(const EmissiveCells &cells, std::size_t cell) {
    return std::span(cells.faces).subspan(cells.first[cell], cells.first[cell + 1] - cells.first[cell]);
}

double part_of(const EmissiveFace &face) { return (double(face.last - face.first) + 1) / 4294967296.0; }

/// How often entries of the table choose each, of all choices.
std::vector<double> chances(std::span<const EmissiveFace> faces) {
    std::vector<double> result(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        result[i] += faces[i].kept / double(faces.size());
        result[faces[i].alias] += (1 - double(faces[i].kept)) / double(faces.size());
    }
    return result;
}

/// 20,000 triangles of sizes over three decades.
std::vector<EmissiveFace> dust() {
    std::mt19937 engine(3);
    std::uniform_real_distribution<float> place(-1, 1), decades(-3, 0);
    std::vector<vec3> positions;
    std::vector<uint> indices;
    for (uint i = 0; i < 20000; ++i) {
        const float size = std::pow(10.0f, decades(engine));
        const vec3 corner(place(engine), place(engine), place(engine));
        for (uint k = 0; k < 3; ++k) {
            indices.push_back(uint(positions.size()));
            positions.push_back(corner + size * vec3(place(engine), place(engine), place(engine)));
        }
    }
    return make_emissive_faces(positions, indices);
}

/// The parts of all cells make up each face, cells have the same area, and each table chooses by the areas of its parts.
void expect_all_of_it(const std::vector<EmissiveFace> &faces, uint count) {
    const EmissiveCells cells = make_emissive_cells(faces, count);
    ASSERT_EQ(cells.first.size(), count + 1);
    double whole = 0;
    for (const EmissiveFace &face : faces) whole += area_of(face);
    EXPECT_NEAR(cells.area, whole, 1e-12 * whole);
    std::map<std::array<float, 3>, double> parts;  // by the corner across
    for (uint cell = 0; cell < count; ++cell) {
        const auto own = faces_of(cells, cell);
        const std::vector<double> chance = chances(own);
        double area = 0, sum = 0;
        for (const EmissiveFace &face : own) {
            const vec3 across = face.corner + face.u + face.v;
            area += area_of(face) * part_of(face), parts[{across.x, across.y, across.z}] += part_of(face);
        }
        // Both ends are rounded to 2^-32 of a face.
        EXPECT_NEAR(area, whole / count, 0x1p-31 * whole) << cell;
        for (std::size_t i = 0; i < own.size(); ++i) {
            // The probabilities are floats: a face may be the alias of some hundred, each off by 2^-25 of an entry's.
            ASSERT_NEAR(chance[i], area_of(own[i]) * part_of(own[i]) / area, 2e-5 / double(own.size())) << cell << ", " << i;
            ASSERT_TRUE(own[i].kept >= 0 && own[i].kept <= 1);
            sum += chance[i];
        }
        EXPECT_NEAR(sum, 1, 1e-9);
    }
    ASSERT_EQ(parts.size(), faces.size());
    for (const auto &[corner, part] : parts) ASSERT_NEAR(part, 1, 1e-9);
}

TEST(EmissiveCells, OfManyFacesMakeUpTheWhole) {
    for (const uint count : {1u, 9u, 256u, 4096u}) expect_all_of_it(dust(), count);
}

TEST(EmissiveCells, OfFewFacesMakeUpTheWhole) {
    const std::vector<vec3> fan = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-3, 1, 0}, {-3, -5, 1}};
    for (const uint count : {1u, 4u, 9u, 4096u}) expect_all_of_it(make_emissive_faces(fan, std::vector<uint>{0, 1, 2, 0, 2, 3, 0, 3, 4}), count);
}

/// 16 cells of a square are sixteenths of the curve.
TEST(EmissiveCells, OfASquareAreAGrid) {
    const EmissiveCells cells =
        make_emissive_cells(make_emissive_faces({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, std::vector<uint>{0, 1, 2, 0, 2, 3}), 16);
    ASSERT_EQ(cells.faces.size(), 16u);
    for (uint i = 0; i < 16; ++i) {
        EXPECT_EQ(cells.faces[i].first, i << 28);
        EXPECT_EQ(cells.faces[i].last, (i << 28) + 0xfffffffu);
    }
}

/// A strip of 64 squares in disorder: each of 16 cells has four neighbours.
TEST(EmissiveCells, OfAStripAreItsPieces) {
    std::vector<vec3> positions;
    std::vector<uint> indices;
    for (uint i = 0; i < 64; ++i) {
        const uint at = i * 37 % 64, first = uint(positions.size());
        for (const vec3 corner : {vec3(0, 0, 0), vec3(1, 0, 0), vec3(1, 1, 0), vec3(0, 1, 0)}) positions.push_back(vec3(2 * at, 0, 0) + corner);
        for (const uint k : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + k);
    }
    const EmissiveCells cells = make_emissive_cells(make_emissive_faces(positions, indices), 16);
    for (uint cell = 0; cell < 16; ++cell) {
        ASSERT_EQ(faces_of(cells, cell).size(), 4u);
        for (const EmissiveFace &face : faces_of(cells, cell))
            EXPECT_EQ(uint(std::floor(std::min(face.corner.x, face.corner.x + face.u.x + face.v.x) / 8)), cell);
    }
}

}  // namespace
}  // namespace brandung
