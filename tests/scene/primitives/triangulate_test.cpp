#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

#include "scene/primitives/add.h"

namespace brandung {
namespace {

using Polygon = std::vector<vec3>;

Polygon flat(const std::vector<vec2> &points) {
    Polygon polygon;
    for (const vec2 p : points) polygon.emplace_back(p, 0);
    return polygon;
}

/// Points on circles whose radii take turns, counterclockwise as seen from +z.
Polygon star(uint vertices, const std::vector<float> &radii) {
    Polygon polygon;
    for (uint i = 0; i < vertices; ++i) {
        const double angle = 2 * std::numbers::pi * i / vertices, radius = radii[i % radii.size()];
        polygon.emplace_back(float(radius * std::cos(angle)), float(radius * std::sin(angle)), 0.25f);
    }
    return polygon;
}

/// A band of width 0.4 along a spiral, out on one side and back on the other.
Polygon spiral(uint steps) {
    Polygon polygon;
    const auto add = [&](uint i, double radius) {
        const double angle = 0.3 * i;
        polygon.emplace_back(float(radius * std::cos(angle)), float(radius * std::sin(angle)), 0);
    };
    for (uint i = 0; i < steps; ++i) add(i, 1 + 0.05 * i + 0.4);
    for (uint i = steps; i-- > 0;) add(i, 1 + 0.05 * i);
    return polygon;
}

glm::dvec3 area(const Polygon &polygon) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < polygon.size(); ++i) sum += glm::cross(glm::dvec3(polygon[i]), glm::dvec3(polygon[(i + 1) % polygon.size()])) / 2.0;
    return sum;
}

/// All triangles look like the polygon, their areas add up to its area, and their edges cancel but for the polygon's own. Together that is a
/// triangulation: none overlaps another or leaves the polygon.
void expect_triangulation(const Polygon &polygon) {
    const std::vector<uint> triangles = triangulate(polygon);
    ASSERT_EQ(triangles.size(), 3 * (polygon.size() - 2));
    const glm::dvec3 whole = area(polygon), normal = glm::normalize(whole);
    double sum = 0;
    std::map<std::pair<uint, uint>, int> edges;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const uint a = triangles[i], b = triangles[i + 1], c = triangles[i + 2];
        const double part = glm::dot(area({polygon[a], polygon[b], polygon[c]}), normal);
        EXPECT_GT(part, 0) << a << " " << b << " " << c;
        sum += part;
        for (const auto &[from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
            ++edges[{from, to}];
            --edges[{to, from}];
        }
    }
    EXPECT_NEAR(sum, glm::length(whole), 1e-6 * glm::length(whole));
    for (const auto &[edge, times] : edges) {
        const bool forward = (edge.first + 1) % polygon.size() == edge.second, backward = (edge.second + 1) % polygon.size() == edge.first;
        EXPECT_EQ(times, forward ? 1 : backward ? -1 : 0) << edge.first << " " << edge.second;
    }
}

TEST(Triangulate, ConvexPolygons) {
    expect_triangulation(flat({{0, 0}, {1, 0}, {0, 1}}));
    expect_triangulation(flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    for (uint n = 5; n < 40; ++n) expect_triangulation(star(n, {1}));
}

TEST(Triangulate, ConcavePolygons) {
    expect_triangulation(flat({{0, 0}, {2, 1}, {0, 2}, {0.5f, 1}}));
    expect_triangulation(star(10, {1, 0.3f}));
    expect_triangulation(star(11, {1, 0.1f, 0.05f}));
    expect_triangulation(flat({{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}));
}

TEST(Triangulate, GearFaceOf144Vertices) {
    // The teeth of the databases' gears: two vertices inside, two outside.
    expect_triangulation(star(144, {1, 1, 0.9f, 0.9f}));
}

TEST(Triangulate, Spiral) { expect_triangulation(spiral(300)); }

TEST(Triangulate, EveryOrientationInSpace) {
    Polygon polygon = star(144, {1, 1, 0.9f, 0.9f});
    for (int turn = 0; turn < 6; ++turn) {
        for (vec3 &p : polygon) p = turn % 2 ? vec3(p.y, p.x, p.z) : vec3(p.y, p.z, p.x);
        expect_triangulation(polygon);
        Polygon reversed = polygon;
        std::reverse(reversed.begin(), reversed.end());
        expect_triangulation(reversed);
    }
    Polygon tilted = spiral(60);
    for (vec3 &p : tilted) p = vec3(p.x + 0.5f * p.y, p.y - p.x, 3 + p.x - 0.25f * p.y);
    expect_triangulation(tilted);
}

TEST(Triangulate, VerticesOnEdgesAreKeptAsCornersOfTriangles) {
    expect_triangulation(flat({{0, 0}, {1, 0}, {2, 0}, {1, 100}}));
    expect_triangulation(flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 3}, {2, 3}, {0, 3}, {0, 2}, {0, 1}}));
    Polygon rectangle;
    for (int i = 0; i < 50; ++i) rectangle.emplace_back(i, 0, 0);
    for (int i = 50; i > 0; --i) rectangle.emplace_back(i, 1, 0);
    expect_triangulation(rectangle);
}

TEST(Triangulate, FloatsThatAreCollinearOnlyWithoutRounding) {
    // Edges at a slope of 1/3 whose vertices are off the line by up to half a unit in the last place.
    Polygon polygon;
    for (int i = 0; i <= 20; ++i) polygon.emplace_back(0.1f * float(i), 0.1f * float(i) / 3, 0);
    polygon.emplace_back(0, 2, 0);
    expect_triangulation(polygon);
}

TEST(Triangulate, RepeatedVerticesAreLeftOut) {
    const Polygon square = flat({{0, 0}, {0, 0}, {1, 0}, {1, 1}, {1, 1}, {1, 1}, {0, 1}, {0, 0}});
    const std::vector<uint> triangles = triangulate(square);
    ASSERT_EQ(triangles.size(), 6u);
    double sum = 0;
    for (std::size_t i = 0; i < 6; i += 3) sum += area({square[triangles[i]], square[triangles[i + 1]], square[triangles[i + 2]]}).z;
    EXPECT_DOUBLE_EQ(sum, 1);
}

double area_of_triangles(const Polygon &polygon) {
    const std::vector<uint> triangles = triangulate(polygon);
    double sum = 0;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const double part = area({polygon[triangles[i]], polygon[triangles[i + 1]], polygon[triangles[i + 2]]}).z;
        EXPECT_GT(part, 0);
        sum += part;
    }
    return sum;
}

TEST(Triangulate, HoleJoinedByABridge) {
    // A square of side 4 with a square hole of side 2; the bridge is walked there and back.
    EXPECT_DOUBLE_EQ(area_of_triangles(flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}})), 12);
}

TEST(Triangulate, SpikeIsLeftOut) { EXPECT_DOUBLE_EQ(area_of_triangles(flat({{0, 0}, {2, 0}, {2, 1}, {5, 1}, {2, 1}, {2, 2}, {0, 2}})), 4); }

TEST(Triangulate, WithoutAreaIsEmpty) {
    EXPECT_TRUE(triangulate({}).empty());
    EXPECT_TRUE(triangulate(flat({{0, 0}, {1, 1}})).empty());
    EXPECT_TRUE(triangulate(flat({{0, 0}, {1, 1}, {2, 2}})).empty());
    EXPECT_TRUE(triangulate(Polygon(7, vec3(1, 2, 3))).empty());
    EXPECT_TRUE(triangulate(flat({{0, 0}, {1, 1}, {3, 3}, {2, 2}, {1, 1}})).empty());
}

TEST(Triangulate, AnyPointsEnd) {
    std::mt19937 random(1);
    for (uint round = 0; round < 2000; ++round) {
        // A coarse grid: many crossings, repetitions and collinear vertices.
        const uint count = 3 + random() % 30, grid = 2 + random() % 20;
        Polygon polygon;
        for (uint i = 0; i < count; ++i) polygon.emplace_back(random() % grid, random() % grid, random() % 2 ? 0 : 1e-3f);
        const std::vector<uint> triangles = triangulate(polygon);
        EXPECT_LE(triangles.size(), 3 * (count - 2));
        for (const uint index : triangles) EXPECT_LT(index, count);
        EXPECT_EQ(triangles, triangulate(polygon));
    }
}

TEST(Triangulate, RandomStarsOnAGrid) {
    // Sorted by angle round the origin, the points make a simple polygon; on a grid many are collinear.
    std::mt19937 random(2);
    for (uint round = 0; round < 500; ++round) {
        std::map<std::pair<int, int>, vec3> by_direction;
        for (int i = 0; i < 40; ++i) {
            const int x = int(random() % 21) - 10, y = int(random() % 21) - 10, divisor = std::gcd(x, y);
            if (divisor != 0) by_direction[{x / divisor, y / divisor}] = vec3(x, y, 0);
        }
        Polygon polygon;
        for (const auto &[direction, point] : by_direction) polygon.push_back(point);
        std::sort(polygon.begin(), polygon.end(), [](vec3 a, vec3 b) { return std::atan2(a.y, a.x) < std::atan2(b.y, b.x); });
        bool around = true;  // else the origin is outside
        for (std::size_t i = 0; i < polygon.size(); ++i) around &= area({vec3(0), polygon[i], polygon[(i + 1) % polygon.size()]}).z > 0;
        if (around) expect_triangulation(polygon);
    }
}

/// Teeth along an axis of the plane, tips apart and reflex corners in line: half of all corners lie in the box of the largest ear.
Polygon comb(uint teeth, bool upright) {
    Polygon polygon = {{0, -1, 0}, {float(teeth), -1, 0}};
    for (uint i = teeth; i > 0; --i) polygon.emplace_back(float(i) - 0.25f, 2, 0), polygon.emplace_back(float(i) - 0.75f, 0, 0);
    if (upright)
        for (vec3 &p : polygon) p = vec3(-p.y, p.x, 0);
    return polygon;
}

TEST(Triangulate, Combs) {
    for (const bool upright : {false, true})
        for (const uint teeth : {1u, 2u, 3u, 10u, 100u}) expect_triangulation(comb(teeth, upright));
}

/// What searches among all corners takes minutes here.
TEST(Triangulate, ManyVerticesTakeNoAge) {
    EXPECT_EQ(triangulate(spiral(100'000)).size(), 3 * 199'998u);
    for (const bool upright : {false, true}) EXPECT_EQ(triangulate(comb(200'000, upright)).size(), 3 * 400'000u);
}

/// Turned and tilted, a comb's corners in line are no longer quite: ears between them are as thin as rounding.
TEST(Triangulate, PolygonsInOrderGiveNoWarnings) {
    Scene scene;
    uint thin = 0;
    for (uint turn = 0; turn < 40; ++turn) {
        const float angle = 0.1f * float(turn), size = std::pow(10.0f, float(turn % 7) - 3);
        Polygon polygon = comb(10, turn % 2 == 1);
        for (vec3 &p : polygon) {
            const vec2 q = size * vec2(p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle));
            p = vec3(q, 0.3f * q.x + 0.7f * q.y);
        }
        MeshData mesh;
        append_polygon(scene, mesh, polygon, {});
        thin += uint(polygon.size() - 2 - mesh.indices.size() / 3);
        add_triangle_mesh(scene, 0, std::move(mesh));
    }
    EXPECT_GT(thin, 0u) << "there are such ears";
    for (const auto &[warning, times] : scene.warnings) ADD_FAILURE() << times << " times: " << warning;
}

}  // namespace
}  // namespace brandung
