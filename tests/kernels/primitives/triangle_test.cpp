/// Which crossings with a triangle count, kernels/primitives/triangle_crossing.cl. How right they are is the self-test's matter.
#include "kernels/primitives/triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "runtime/selftest/extended.h"
#include "tests/kernels/primitives/crossing_probe.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {

extern const PrimitiveKind triangle_kind;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::size_t count = 100'000;

using Triangle = std::array<vec3, 3>;

std::unique_ptr<Shape> shape_of(const Triangle &t) { return make_triangle_mesh(0, MeshData{.positions = {t[0], t[1], t[2]}, .indices = {0, 1, 2}}); }

CrossingProbe<TriangleBlock> probe_of(const std::vector<Triangle> &triangles) {
    std::vector<std::unique_ptr<Shape>> shapes;
    for (const Triangle &triangle : triangles) shapes.push_back(shape_of(triangle));
    return {triangle_kind, shapes};
}

CrossingResult crossing(const Triangle &triangle, vec3 origin, vec3 direction, float t_max = infinity) {
    return probe_of({triangle}).crossings({make_ray(origin, direction, t_max)})[0];
}

Vector normal_of(const Triangle &t) { return cross(Vector(t[1]) - Vector(t[0]), Vector(t[2]) - Vector(t[0])); }

const Triangle one = {vec3(-1, -1, 0), vec3(1, -1, 0), vec3(0, 1, 0)};

TEST(Triangle, BothSidesAreMetWithWeightsOfBAndC) {
    for (const float side : {1.0f, -1.0f}) {
        const CrossingResult result = crossing(one, {0.25f, -0.5f, 2 * side}, {0, 0, -side});
        ASSERT_TRUE(result.hit);
        EXPECT_EQ(result.t, 2);
        EXPECT_EQ(result.u, 0.5f);   // b: (0.25 + 1 - 2 v / 2) / 2 with v = 1/4
        EXPECT_EQ(result.v, 0.25f);  // c: (-0.5 + 1) / 2
    }
}

TEST(Triangle, NothingIsMetBehindBesideInThePlaneOrBeyondTheRaysEnd) {
    EXPECT_FALSE(crossing(one, {0, 0, -1}, {0, 0, -1}).hit);
    EXPECT_FALSE(crossing(one, {0, 1.001f, 1}, {0, 0, -1}).hit);
    EXPECT_FALSE(crossing(one, {-5, 0, 0}, {1, 0, 0}).hit);
    EXPECT_FALSE(crossing(one, {0, 0, 1}, {0, 0, -1}, 0.999f).hit);
    EXPECT_TRUE(crossing(one, {0, 0, 1}, {0, 0, -1}, 1).hit);
    EXPECT_FALSE(crossing(one, {0, 0, 0}, {0, 0, -1}).hit);
}

/// Eyes 2^-30 to 1 of a triangle's size above or below it, as over a floor that reaches to the horizon: what is ahead is met, what is behind isn't.
TEST(Triangle, OnWhichSideARayBeginsIsDecidedRight) {
    Random random(9);
    std::vector<Triangle> triangles;
    std::vector<Ray> rays;
    std::vector<long double> expected;
    while (rays.size() < count) {
        const float size = std::exp2(random.uniform(-15, 15));
        const Triangle triangle = {random.direction() * size, random.direction() * size, random.direction() * size};
        const Vector n = normal_of(triangle);
        if (!shape_of(triangle) || length(n) < 0.5L * size * size) continue;
        const float s = random.uniform(0.2f, 0.4f), t = random.uniform(0.2f, 0.4f);
        const vec3 above = triangle[0] * (1 - s - t) + triangle[1] * s + triangle[2] * t;
        const vec3 origin = above + random.direction() * (size * std::exp2(random.uniform(-30, -6)));
        const Ray ray = make_ray(origin, random.direction());
        const long double cosine = dot(ray.direction, unit(n)), height = dot(Vector(origin) - Vector(triangle[0]), unit(n));
        if (std::abs(cosine) < 0.1L || std::abs(height) < 0x1p-34L * size) continue;  // the exact offset is right to 2^-42 of the lengths
        triangles.push_back(triangle), rays.push_back(ray), expected.push_back(-height / cosine);
    }
    const std::vector<CrossingResult> results = probe_of(triangles).crossings(rays);
    std::size_t hits = 0, very_near = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(results[i].hit, expected[i] > 0) << i << ": t " << expected[i];
        if (!results[i].hit) continue;
        ++hits;
        const long double size = length(Vector(triangles[i][0]));
        // Below 2^-19 of the size twice the digits take over.
        const long double cosine = absolute(dot(rays[i].direction, unit(normal_of(triangles[i]))));
        const long double error = expected[i] < 0x1p-20L * size ? 16 * unit_roundoff / cosine * expected[i] + 0x1p-38L * size
                                                                : unit_roundoff * 2 * size * (25 / cosine + 8 * std::sqrt(3.0L));
        ASSERT_NEAR(results[i].t, expected[i], error) << i;
        very_near += expected[i] < 0x1p-20L * size;
    }
    EXPECT_GT(hits, count / 3);
    EXPECT_GT(very_near, count / 10);
}

/// A net over the square from 0 to `size`: squares with whole corners of any height from 0 to 7, each cut along one of its diagonals.
std::vector<Triangle> hilly_net(int size, Random &random) {
    std::vector<vec3> corners;
    for (int i = 0; i < (size + 1) * (size + 1); ++i) corners.emplace_back(i % (size + 1), i / (size + 1), float(random.below(8)));
    std::vector<Triangle> triangles;
    for (int i = 0; i < size * size; ++i) {
        const int low = i / size * (size + 1) + i % size, high = low + size + 1;
        const std::array<vec3, 4> q = {corners[low], corners[low + 1], corners[high + 1], corners[high]};
        const uint turn = random.below(2);
        triangles.push_back({q[turn], q[turn + 1], q[turn + 2]});
        triangles.push_back({q[turn + 2], q[(turn + 3) % 4], q[turn]});
        if (random.below(2) == 0) std::swap(triangles.back()[0], triangles.back()[1]);
    }
    return triangles;
}

/// Rays from above a hilly net to below it through its vertices and its edges' middles, some along its outlines: shears are exact in binary here.
TEST(Triangle, RaysThroughEdgesAndVerticesCrossEverySurfaceOnce) {
    constexpr int size = 12;
    Random random(11);
    const std::vector<Triangle> net = hilly_net(size, random);
    std::vector<Triangle> triangles;
    std::vector<Ray> rays;
    for (const vec3 direction : {vec3(0, 0, -1), vec3(0.25f, -0.125f, -1), vec3(-0.25f, 0.25f, -1), vec3(0, 0.25f, -1)})
        for (const Triangle &aim : net)
            for (const vec3 through : {aim[0], (aim[0] + aim[1]) * 0.5f, (aim[1] + aim[2]) * 0.5f}) {
                if (glm::min(through.x, through.y) < 2 || glm::max(through.x, through.y) > size - 2) continue;  // stays over the net
                const Ray ray = make_ray(through - direction * 16.0f, direction);
                triangles.insert(triangles.end(), net.begin(), net.end());
                rays.insert(rays.end(), net.size(), ray);
            }
    const std::vector<CrossingResult> results = probe_of(triangles).crossings(rays);
    for (std::size_t i = 0; i < results.size(); i += net.size()) {
        const auto crossed = std::count_if(&results[i], &results[i] + net.size(), [](const CrossingResult &result) { return result.hit != 0; });
        if (rays[i].direction.x == 0 && rays[i].direction.y == 0) {
            ASSERT_EQ(crossed, 1) << i;
        } else {
            ASSERT_EQ(crossed % 2, 1) << i;  // in at an outline and out again
        }
    }
}

/// Scenes may have coordinates up to 10^15; triangles of 10^-15 are met too.
TEST(Triangle, BothEndsOfTheRangeOfCoordinatesWork) {
    for (const float scale : {1e-15f, 1e-12f, 1e12f, 1e15f}) {
        const Triangle triangle = {vec3(-1, -1, 0) * scale, vec3(1, -1, 0) * scale, vec3(0, 1, 0.5f) * scale};
        const CrossingResult far = crossing(triangle, vec3(0.25f, -0.5f, 2) * scale, {0, 0, -1});
        ASSERT_TRUE(far.hit) << scale;
        EXPECT_NEAR(far.t, 1.875f * scale, 1e-6f * scale);
        const CrossingResult near = crossing(triangle, vec3(0.25f, -0.5f, 0.1250001f) * scale, {0, 0, -1});
        ASSERT_TRUE(near.hit) << scale;
        EXPECT_LT(near.t, 2e-7f * scale);
        EXPECT_FALSE(crossing(triangle, vec3(0.25f, -0.5f, 0.1249999f) * scale, {0, 0, -1}).hit) << scale;
    }
}

}  // namespace
}  // namespace brandung
