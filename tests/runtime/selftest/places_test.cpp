/// runtime/selftest/places.h: which faces a ray meets in one place.
#include "runtime/selftest/places.h"

#include <gtest/gtest.h>

#include <limits>

namespace brandung {
namespace {

/// A square from (0, 0) to (2, 1) in z = 1, of faces 0 and 1 that share the edge from (0, 0) to (1, 1), and 2 and 3 on the other side of x = 1: all
/// but 0 and 3 meet in vertices or edges.
const MeshData mesh = {.positions = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {2, 0, 1}, {2, 1, 1}},
                       .normals = {},
                       .uvs = {},
                       .colors = {},
                       .indices = {0, 2, 3, 0, 1, 2, 1, 4, 2, 4, 5, 2},
                       .numbers = {}};

uint places(float x, float y, std::vector<uint> faces) {
    const Ray ray = {.origin = {x, y, 0}, .t_max = std::numeric_limits<float>::infinity(), .direction = {0, 0, 1}, .tag = 0};
    return places_met(mesh, ray, faces);
}

TEST(PlacesMet, ThoseOfNeighboursAreOneOnTheirEdgeOnly) {
    EXPECT_EQ(places(0.25f, 0.75f, {0}), 1u);
    EXPECT_EQ(places(0.5f, 0.5f, {0, 1}), 1u);
    EXPECT_EQ(places(0.5f, 0.5f + 0x1p-23f, {0, 1}), 1u) << "2^-23.5 beside it, of the 9.1 * 2^-24 that rounding can be of 1";
    EXPECT_EQ(places(0.5f, 0.5f + 0x1p-19f, {0, 1}), 2u);
    EXPECT_EQ(places(1, 0.5f, {1, 2}), 1u);
    EXPECT_EQ(places(0.5f, 0.5f, {0, 3}), 2u) << "they share a vertex elsewhere";
}

TEST(PlacesMet, FacesAroundAVertexAreOneThere) {
    EXPECT_EQ(places(1, 1, {0, 1, 2, 3}), 1u);
    EXPECT_EQ(places(1, 0, {0, 1, 2}), 2u) << "the first does not reach there";
    EXPECT_EQ(places(1, 0.5f, {1, 2, 3, 0}), 3u);
}

}  // namespace
}  // namespace brandung
