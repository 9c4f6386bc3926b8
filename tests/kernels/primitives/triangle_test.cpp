/// kernels/primitives/triangle.cl and triangle_crossing.cl against extended precision.
#include "kernels/primitives/triangle.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/kernels/primitives/crossing_oracle.h"
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

/// Distance from the origin to the segment from p to q.
real distance_to_segment(Vector p, Vector q) {
    const Vector along = q - p;
    const real squared = dot(along, along), s = squared > 0 ? std::clamp(-dot(p, along) / squared, 0.0L, 1.0L) : 0;
    return length(p + along * s);
}

/// t by the plane, inside or not by the projection along the ray; the kernel does both by sheared edge functions.
///
/// Rounding, with u = 2^-24 and M the largest coordinate of a vertex seen from the origin: a sheared coordinate is off by 6 u M (two differences,
/// |shear| <= 1 and its product), so the ray passes a vertex at a distance that is off by 9 u M at most. Within that of an edge anything goes.
/// z, which is t times the direction's largest component, is the mean of the vertices' z with weights that are right for such vertices to 8 u: the
/// point lies in the true plane but for (9 + 16) u M, times the plane's slope, which is at most 1 / cosine; and the mean itself is off by 8 u M.
std::vector<Root> roots_of(const Triangle &triangle, const Ray &ray) {
    const Vector d = ray.direction, o = ray.origin, n = normal_of(triangle);
    const real d_length = length(d), u = unit_roundoff;
    Vector seen[3] = {Vector(triangle[0]) - o, Vector(triangle[1]) - o, Vector(triangle[2]) - o};
    real largest = 0;
    for (const Vector &v : seen) largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    const real t = dot(seen[0], n) / dot(d, n), cosine = std::abs(dot(d, n)) / (d_length * length(n));
    const real error = u * largest * (25 / cosine + 8 * std::sqrt(3.0L)) / d_length;

    Vector across[3] = {seen[0], seen[1], seen[2]};
    for (Vector &v : across) v = v - d * (dot(v, d) / dot(d, d));
    real to_edges = distance_to_segment(across[0], across[1]);
    to_edges = std::min({to_edges, distance_to_segment(across[1], across[2]), distance_to_segment(across[2], across[0])});
    bool positive = true, negative = true;
    for (int i = 0; i < 3; ++i) {
        const real side = dot(d, cross(across[i], across[(i + 1) % 3]));
        positive &= side >= 0, negative &= side <= 0;
    }
    const bool inside = positive || negative, near_edge = to_edges <= 9 * u * largest;
    if (!(inside || near_edge) || !std::isfinite(t)) return {};
    return {{t, error, inside && !near_edge}};
}

struct Cases {
    std::vector<Triangle> triangles;
    std::vector<Ray> rays;
};
/// Triangles of three sizes with rays through, beside, from and along them; `thin` makes slivers of aspect up to 2^thin, `far` how many sizes away
/// the origins are at most (in bits).
Cases random_cases(uint seed, int offset_bits, int thin, int far) {
    Random random(seed);
    Cases cases;
    while (cases.rays.size() < count) {
        const float size = std::exp2(float(int(random.below(3)) - 1) * 20) * random.uniform(0.5f, 1);
        const vec3 a = random.direction() * (size * std::exp2(random.uniform(-2, float(offset_bits))));
        const vec3 b = a + random.direction() * size;
        const vec3 c = a + (b - a) * random.uniform(0, 1) + random.direction() * (size * std::exp2(-random.uniform(0, float(thin))));
        if (!shape_of({a, b, c})) continue;
        const float s = random.uniform(-0.1f, 1.1f), t = random.uniform(-0.1f, 1.1f);
        const vec3 target = a + (b - a) * s * (1 - t) + (c - a) * t;
        const vec3 origin = target + random.direction() * (size * std::exp2(random.uniform(-4, float(far))));
        const vec3 towards = random.below(8) == 0 ? random.direction() : vec3(glm::normalize(glm::dvec3(target) - glm::dvec3(origin)));
        const vec3 direction = random.below(4) == 0 ? towards * std::exp2(random.uniform(-8, 8)) : towards;
        if (!(glm::length(direction) > 0)) continue;
        const float t_max = random.below(4) == 0 ? glm::length(target - origin) / glm::length(direction) : infinity;
        cases.triangles.push_back({a, b, c});
        cases.rays.push_back(make_ray(origin, direction, t_max));
    }
    return cases;
}

/// How many of the cases rounding doesn't explain.
std::size_t unexplained(const Cases &cases, std::size_t &sure) {
    const std::vector<CrossingResult> results = probe_of(cases.triangles).crossings(cases.rays);
    std::size_t bad = 0;
    for (std::size_t i = 0; i < cases.rays.size(); ++i) {
        const std::vector<Root> roots = roots_of(cases.triangles[i], cases.rays[i]);
        sure += sure_hits(roots, cases.rays[i].t_max);
        const testing::AssertionResult result = explains(roots, results[i], cases.rays[i].t_max);
        if (!result && ++bad <= 3) ADD_FAILURE() << "case " << i << ": " << result.message();
    }
    return bad;
}

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

TEST(Triangle, CrossingsAreWhatRoundingExplains) {
    for (const int offset_bits : {2, 10, 20}) {
        std::size_t sure = 0;
        EXPECT_EQ(unexplained(random_cases(uint(offset_bits), offset_bits, 3, 12), sure), 0u) << "offset 2^" << offset_bits;
        EXPECT_GT(sure, count / 4) << "offset 2^" << offset_bits;
    }
}

TEST(Triangle, CrossingsOfSliversAreWhatRoundingExplains) {
    std::size_t sure = 0;
    EXPECT_EQ(unexplained(random_cases(4, 2, 16, 10), sure), 0u);
    EXPECT_GT(sure, count / 4);
}

TEST(Triangle, CrossingsOfTrianglesFarAwayAreWhatRoundingExplains) {
    std::size_t sure = 0;
    EXPECT_EQ(unexplained(random_cases(5, 2, 3, 19), sure), 0u);
    EXPECT_GT(sure, count / 4);
}

TEST(Triangle, AllWidthsGiveTheSameBits) {
    Random random(2);
    std::vector<Triangle> triangles;
    std::vector<Ray> rays;
    while (rays.size() < count / 16 * 16) {
        const float size = std::exp2(random.uniform(-20, 20));
        const vec3 center = random.in_cube(16) * size;
        for (int i = 0; i < 16; ++i) {
            Triangle triangle;
            do {
                for (vec3 &vertex : triangle) vertex = center + random.in_cube(1) * size;
            } while (!shape_of(triangle));
            triangles.push_back(triangle);
            const vec3 origin = center + random.in_cube(4) * size, target = center + random.in_cube(0.5f) * size;
            rays.push_back(make_ray(origin, (target - origin) * std::exp2(random.uniform(-4, 4)), random.below(4) ? infinity : 1.0f));
        }
    }
    const WidthResult result = probe_of(triangles).compare_widths(rays);
    EXPECT_GT(result.hits, count / 2);
    EXPECT_EQ(result.different_8, 0u);
    EXPECT_EQ(result.different_16, 0u);
}

/// Eyes 2^-30 to 1 of a triangle's size above or below it, as over a floor that reaches to the horizon: what is ahead is met, what is behind isn't.
TEST(Triangle, OnWhichSideARayBeginsIsDecidedRight) {
    Random random(9);
    std::vector<Triangle> triangles;
    std::vector<Ray> rays;
    std::vector<real> expected;
    while (rays.size() < count) {
        const float size = std::exp2(random.uniform(-15, 15));
        const Triangle triangle = {random.direction() * size, random.direction() * size, random.direction() * size};
        const Vector n = normal_of(triangle);
        if (!shape_of(triangle) || length(n) < 0.5L * size * size) continue;
        const float s = random.uniform(0.2f, 0.4f), t = random.uniform(0.2f, 0.4f);
        const vec3 above = triangle[0] * (1 - s - t) + triangle[1] * s + triangle[2] * t;
        const vec3 origin = above + random.direction() * (size * std::exp2(random.uniform(-30, -6)));
        const Ray ray = make_ray(origin, random.direction());
        const real cosine = dot(ray.direction, unit(n)), height = dot(Vector(origin) - Vector(triangle[0]), unit(n));
        if (std::abs(cosine) < 0.1L || std::abs(height) < 0x1p-34L * size) continue;  // the exact offset is right to 2^-42 of the lengths
        triangles.push_back(triangle), rays.push_back(ray), expected.push_back(-height / cosine);
    }
    const std::vector<CrossingResult> results = probe_of(triangles).crossings(rays);
    std::size_t hits = 0, very_near = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(results[i].hit, expected[i] > 0) << i << ": t " << expected[i];
        if (!results[i].hit) continue;
        ++hits;
        const real size = length(Vector(triangles[i][0]));
        // Below 2^-19 of the size twice the digits take over.
        const real cosine = std::abs(dot(rays[i].direction, unit(normal_of(triangles[i]))));
        const real error = expected[i] < 0x1p-20L * size ? 16 * unit_roundoff / cosine * expected[i] + 0x1p-38L * size
                                                         : unit_roundoff * 2 * size * (25 / cosine + 8 * std::sqrt(3.0L));
        ASSERT_NEAR(results[i].t, expected[i], error) << i;
        very_near += expected[i] < 0x1p-20L * size;
    }
    EXPECT_GT(hits, count / 3);
    EXPECT_GT(very_near, count / 10);
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

/// Stands for offset_bits: one vertex lies at the origin, and hits near it, where errors that follow the point's coordinates vanish.
constexpr int at_the_origin = -1;

class TriangleAtScale : public testing::TestWithParam<std::pair<float, int>> {};

struct Spawned {
    std::vector<Triangle> triangles;
    std::vector<Ray> rays;
    std::vector<vec3> directions;
    std::vector<SpawnResult> results;
};
Spawned spawn_at(float scale, int offset_bits, uint seed) {
    Random random(seed);
    Spawned spawned;
    while (spawned.rays.size() < count / 4) {
        const bool at_origin = offset_bits == at_the_origin;
        const vec3 a = at_origin ? vec3(0) : random.direction() * (scale * std::exp2(random.uniform(0, float(offset_bits))));
        const vec3 b = a + random.direction() * scale, c = a + random.direction() * scale;
        if (!shape_of({a, b, c})) continue;
        const float near = at_origin ? std::exp2(random.uniform(-24, 0)) : 1, s = near * random.uniform(0, 1), t = near * random.uniform(0, 1 - s);
        const vec3 target = a + (b - a) * s + (c - a) * t;
        const vec3 origin = target + random.direction() * (scale * random.uniform(1, 100));
        spawned.triangles.push_back({a, b, c});
        spawned.rays.push_back(make_ray(origin, vec3(glm::normalize(glm::dvec3(target) - glm::dvec3(origin)))));
        spawned.directions.push_back(random.direction());
    }
    spawned.results = probe_of(spawned.triangles).spawned(spawned.rays, spawned.directions);
    return spawned;
}

/// The edges are rounded to u of their length, or exact; then n = e x f is off by 4 u |e| |f| in each component, however small |n| is,
/// and its direction by 4 sqrt(3) u |e| |f| / |n|; unit() adds 4 u.
TEST_P(TriangleAtScale, SurfacesLieWithinTheirErrorsAndFaceTheCounterclockwiseSide) {
    const auto [scale, offset_bits] = GetParam();
    const Spawned spawned = spawn_at(scale, offset_bits, 3);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < spawned.results.size(); ++i) {
        const SpawnResult &result = spawned.results[i];
        if (!result.first.hit) continue;
        ++hits;
        const Triangle &triangle = spawned.triangles[i];
        const Vector n = normal_of(triangle), e = Vector(triangle[1]) - Vector(triangle[0]), f = Vector(triangle[2]) - Vector(triangle[0]);
        const Vector off = Vector(result.surface.p) - Vector(triangle[0]);
        ASSERT_LE(std::abs(dot(off, unit(n))), dot(Vector(glm::abs(result.surface.geometric)), result.surface.error)) << i;
        ASSERT_LE(length(Vector(result.surface.error)), 0x1p-19L * (length(Vector(triangle[0])) + 2 * scale)) << "the bound is no use if it is wide";
        const real error = 12 * unit_roundoff * length(e) * length(f) / length(n) + 8 * unit_roundoff;
        ASSERT_LE(length(Vector(result.surface.geometric) - unit(n)), error) << i;
        ASSERT_EQ(result.surface.normal, result.surface.geometric);
    }
    EXPECT_GT(hits, count / 8);
}

TEST_P(TriangleAtScale, RaysThatLeaveItNeverMeetItAgain) {
    const auto [scale, offset_bits] = GetParam();
    const Spawned spawned = spawn_at(scale, offset_bits, 4);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < spawned.results.size(); ++i) {
        const SpawnResult &result = spawned.results[i];
        if (!result.first.hit) continue;
        ++hits;
        const Vector n = unit(normal_of(spawned.triangles[i]));
        const real side = dot(n, spawned.directions[i]);
        const real height = dot(Vector(result.origin) - Vector(spawned.triangles[i][0]), n);
        // Directions within the normal's own error of the plane have no side; a vertex at the origin is an exact point, from which nothing is moved.
        if (std::abs(side) > 0x1p-12L && result.surface.error != vec3(0)) {
            ASSERT_GT(height * side, 0) << "the origin lies on the side to which the ray leaves";
        }
        ASSERT_FALSE(result.second.hit) << i << ": cosine " << side << ", t " << result.second.t;
    }
    EXPECT_GT(hits, count / 8);
}

INSTANTIATE_TEST_SUITE_P(Scales, TriangleAtScale,
                         testing::Values(std::pair{1e-6f, 2}, std::pair{1.0f, 2}, std::pair{1e6f, 2}, std::pair{1.0f, 10}, std::pair{1e-6f, 20},
                                         std::pair{1.0f, at_the_origin}, std::pair{1.0f, 20}, std::pair{1e6f, 20}));

}  // namespace
}  // namespace brandung
