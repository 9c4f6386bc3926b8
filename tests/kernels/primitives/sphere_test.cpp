/// kernels/primitives/sphere.cl and sphere_hit.cl against extended precision.
#include "kernels/primitives/sphere.h"

#include <gtest/gtest.h>

#include "tests/kernels/primitives/crossing_oracle.h"
#include "tests/kernels/primitives/crossing_probe.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {

extern const PrimitiveKind sphere_kind;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::size_t count = 100'000;

struct Sphere {
    vec3 center;
    float radius;
};

std::vector<std::unique_ptr<Shape>> shapes_of(const std::vector<Sphere> &spheres) {
    std::vector<std::unique_ptr<Shape>> shapes;
    for (const Sphere &sphere : spheres) shapes.push_back(make_sphere(0, sphere.center, sphere.radius));
    return shapes;
}

CrossingProbe<SphereBlock> probe_of(const std::vector<Sphere> &spheres) { return {sphere_kind, shapes_of(spheres)}; }

CrossingResult crossing(Sphere sphere, vec3 origin, vec3 direction, float t_max = infinity) {
    return probe_of({sphere}).crossings({make_ray(origin, direction, t_max)})[0];
}

/// Roots from the distance between centre and ray as a cross product, which the kernel doesn't use.
///
/// Rounding, with u = 2^-24, f = o - c, distances along the ray (t |d|), r = |radius|:
/// f is exact to u |f|; b = -f.d has 3 operations of relative error u on terms that sum to |f| |d|, b / a 4 more: together, the foot of the
/// perpendicular m is off by e <= 12 u |f|. Then D = r^2 - m^2 is off by dD <= 2 m e + e^2 + 4 u (r^2 + m^2), and sqrt(D) by min(sqrt(dD), dD /
/// sqrt(D)). q / a adds 8 u |f|; c / q, where c = f^2 - r^2 is off by 5 u (f^2 + r^2), adds that by |q| >= max(|b|, sqrt(D)).
std::vector<Root> roots_of(const Sphere &sphere, const Ray &ray) {
    const Vector d = ray.direction, f = Vector(ray.origin) - Vector(sphere.center);
    const real r = std::abs(sphere.radius), a = dot(d, d), u = unit_roundoff;
    const real f_length = length(f), m = length(cross(f, d)) / std::sqrt(a), middle = -dot(f, d) / a;
    const real e = 12 * u * f_length, m_or_r = std::max(m, r);
    const real discriminant = r * r - m * m, error = 2 * m_or_r * e + e * e + 4 * u * (r * r + m * m);
    if (discriminant < -error) return {};
    const bool sure = discriminant > error;
    const real half = std::sqrt(std::max(discriminant, 0.0L));
    const real half_error = sure ? std::min(std::sqrt(error), error / half) : 2 * std::sqrt(error);
    const real q = std::max({std::abs(middle) * std::sqrt(a), half, std::sqrt(error)});
    const real total = (half_error + 8 * u * (f_length + r) + 5 * u * (f_length * f_length + r * r) / q) / std::sqrt(a);
    const real t0 = middle - half / std::sqrt(a), t1 = middle + half / std::sqrt(a);
    std::vector<Root> roots;
    if (sphere.radius > 0) roots.push_back({t0, total, sure});
    roots.push_back({t1, total, sure});
    return roots;
}

/// Spheres of all sizes, at up to 2^20 radii from the origin, with rays that pass at up to 1.2 radii, from near, far or inside.
struct Cases {
    std::vector<Sphere> spheres;
    std::vector<Ray> rays;
};
Cases random_cases(uint seed, int offset_bits) {
    Random random(seed);
    Cases cases;
    for (std::size_t i = 0; i < count; ++i) {
        const float size = std::exp2(float(int(random.below(3)) - 1) * 20) * random.uniform(0.5f, 1);
        const vec3 center = random.direction() * (size * std::exp2(random.uniform(-2, float(offset_bits))));
        const float radius = random.below(5) == 0 ? -size : size;
        const vec3 target = center + random.direction() * (size * random.uniform(0, 1.2f));
        const vec3 origin =
            random.below(4) == 0 ? center + random.in_cube(0.5f) * size : target + random.direction() * (size * std::exp2(random.uniform(-3, 12)));
        const vec3 towards = random.below(4) == 0 ? random.direction() : vec3(glm::normalize(glm::dvec3(target) - glm::dvec3(origin)));
        const vec3 direction = random.below(4) == 0 ? towards * std::exp2(random.uniform(-8, 8)) : towards;
        const float t_max = random.below(4) == 0 ? glm::length(target - origin) / glm::length(direction) : infinity;
        cases.spheres.push_back({center, radius});
        cases.rays.push_back(make_ray(origin, direction, t_max));
    }
    return cases;
}

TEST(Sphere, CrossingIsTheNearerRootFromOutsideAndTheFartherFromInside) {
    EXPECT_EQ(crossing({{0, 0, 5}, 1}, {0, 0, 0}, {0, 0, 1}).t, 4);
    EXPECT_EQ(crossing({{0, 0, 5}, 1}, {0, 0, 5}, {0, 0, 1}).t, 1);
    EXPECT_EQ(crossing({{0, 0, 5}, 1}, {0, 0, 0}, {0, 0, 2}).t, 2);
}

TEST(Sphere, NothingIsMetBehindBesideOrBeyondTheRaysEnd) {
    EXPECT_FALSE(crossing({{0, 0, 5}, 1}, {0, 0, 7}, {0, 0, 1}).hit);
    EXPECT_FALSE(crossing({{0, 0, 5}, 1}, {0, 1.001f, 0}, {0, 0, 1}).hit);
    EXPECT_FALSE(crossing({{0, 0, 5}, 1}, {0, 0, 0}, {0, 0, 1}, 3.999f).hit);
    EXPECT_TRUE(crossing({{0, 0, 5}, 1}, {0, 0, 0}, {0, 0, 1}, 4).hit);
}

TEST(Sphere, ATangentIsMet) {
    const CrossingResult result = crossing({{0, 0, 5}, 1}, {0, 1, 0}, {0, 0, 1});
    EXPECT_TRUE(result.hit);
    EXPECT_EQ(result.t, 5);
}

TEST(Sphere, OfNegativeRadiusOnlyTheInsideIsSeen) {
    EXPECT_EQ(crossing({{0, 0, 5}, -1}, {0, 0, 0}, {0, 0, 1}).t, 6);
    EXPECT_EQ(crossing({{0, 0, 5}, -1}, {0, 0, 5}, {0, 0, 1}).t, 1);
    EXPECT_FALSE(crossing({{0, 0, 5}, -1}, {0, 0, 0}, {0, 0, 1}, 5.5f).hit);
}

TEST(Sphere, ARayThatBeginsOnItDoesNotMeetItThere) {
    EXPECT_FALSE(crossing({{0, 0, 5}, 1}, {0, 0, 6}, {0, 0, 1}).hit);
    EXPECT_EQ(crossing({{0, 0, 5}, 1}, {0, 0, 4}, {0, 0, 1}).t, 2);
}

/// Origins on the sphere to within rounding, or up to 2^-2 radii from it. The side counts, however near: from inside every ray meets the sphere
/// ahead, from outside those that point inwards do at once, and those that point outwards never.
TEST(Sphere, OnWhichSideARayBeginsIsDecidedRight) {
    Random random(3);
    std::vector<Sphere> spheres;
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const float radius = std::exp2(random.uniform(-20, 20));
        const vec3 center = random.below(2) ? vec3(0) : random.in_cube(4) * radius;
        const double height = random.below(2) ? 0 : random.uniform(-1, 1) * std::exp2(random.uniform(-40, -2));
        spheres.push_back({center, radius});
        rays.push_back(
            make_ray(vec3(glm::dvec3(center) + glm::normalize(glm::dvec3(random.direction())) * (1 + height) * double(radius)), random.direction()));
    }
    const std::vector<CrossingResult> results = probe_of(spheres).crossings(rays);
    std::size_t inside = 0, outside = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Vector f = Vector(rays[i].origin) - Vector(spheres[i].center), d = rays[i].direction;
        const real r = spheres[i].radius, a = dot(d, d), b = dot(f, d), c = dot(f, f) - r * r;
        if (std::abs(b) < 0x1p-6L * r || b * b - a * c < 0x1p-12L * r * r) continue;  // grazing
        const real q = b < 0 ? -b + std::sqrt(b * b - a * c) : -b - std::sqrt(b * b - a * c);
        const real t = c > 0 ? c / q : std::max(c / q, q / a);
        ASSERT_EQ(results[i].hit, t > 0) << i << ": offset " << c / (r * r) << ", b " << b / r << ", t " << results[i].t;
        // The discriminant is off by 24 u r^2, so its root by 12 u r^2 / b and q by 6 u (r / b)^2 of itself; c's absolute error is 2^-42 r^2.
        if (results[i].hit) {
            ASSERT_NEAR(results[i].t, t, 16 * unit_roundoff * (r / b) * (r / b) * t + 0x1p-36L * r) << i;
        }
        (c < 0 ? inside : outside) += 1;
    }
    EXPECT_GT(inside, count / 4);
    EXPECT_GT(outside, count / 4);
}

TEST(Sphere, CrossingsAreWhatRoundingExplains) {
    for (const int offset_bits : {2, 10, 20}) {
        const Cases cases = random_cases(uint(offset_bits), offset_bits);
        const std::vector<CrossingResult> results = probe_of(cases.spheres).crossings(cases.rays);
        std::size_t sure = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const std::vector<Root> roots = roots_of(cases.spheres[i], cases.rays[i]);
            sure += sure_hits(roots, cases.rays[i].t_max);
            ASSERT_TRUE(explains(roots, results[i], cases.rays[i].t_max)) << "case " << i << " of offset 2^" << offset_bits;
        }
        EXPECT_GT(sure, count / 4) << "of offset 2^" << offset_bits;
    }
}

TEST(Sphere, AllWidthsGiveTheSameBits) {
    const Cases cases = random_cases(1, 10);
    std::vector<Sphere> spheres = cases.spheres;
    // Neighbours of a block in size and place, so that one ray meets several.
    Random random(2);
    for (std::size_t i = 0; i < count; ++i) {
        const Sphere &first = cases.spheres[i / 16 * 16];
        const float r = std::abs(first.radius);
        spheres[i] = {first.center + random.in_cube(0.5f) * r, first.radius * random.uniform(0.5f, 1)};
    }
    std::vector<Ray> rays = cases.rays;
    for (std::size_t i = 0; i < count; ++i) {
        const Sphere &first = spheres[i / 16 * 16];
        const vec3 origin = first.center + random.in_cube(4) * std::abs(first.radius),
                   target = first.center + random.in_cube(1) * std::abs(first.radius);
        rays[i] = make_ray(origin, (target - origin) * std::exp2(random.uniform(-4, 4)), random.below(4) ? infinity : 1.0f);
    }
    const WidthResult result = probe_of(spheres).compare_widths(rays);
    EXPECT_GT(result.hits, count);
    EXPECT_EQ(result.different_8, 0u);
    EXPECT_EQ(result.different_16, 0u);
}

/// Hits from outside and inside, and rays that leave them to either side.
struct Spawned {
    std::vector<Sphere> spheres;
    std::vector<Ray> rays;
    std::vector<vec3> directions;
    std::vector<SpawnResult> results;
};
Spawned spawn_at(float scale, int offset_bits, uint seed) {
    Random random(seed);
    Spawned spawned;
    for (std::size_t i = 0; i < count / 4; ++i) {
        const float radius = scale * random.uniform(0.5f, 2);
        const vec3 center = random.direction() * (radius * std::exp2(random.uniform(0, float(offset_bits))));
        const vec3 target = center + random.direction() * (radius * random.uniform(0, 0.99f));
        const vec3 origin =
            random.below(2) ? center + random.in_cube(0.5f) * radius : target + random.direction() * (radius * random.uniform(1, 100));
        spawned.spheres.push_back({center, radius});
        spawned.rays.push_back(make_ray(origin, vec3(glm::normalize(glm::dvec3(target) - glm::dvec3(origin)))));
        spawned.directions.push_back(random.direction());
    }
    spawned.results = probe_of(spawned.spheres).spawned(spawned.rays, spawned.directions);
    return spawned;
}

class SphereAtScale : public testing::TestWithParam<std::pair<float, int>> {};

/// f = o + t d - c has 3 roundings of magnitudes up to |o| + |c| + t, so the normal is off by 8 u (|f| + t) / r and by 4 u from its own length;
/// t's own error moves the point along the ray, which is no error of the normal there.
TEST_P(SphereAtScale, SurfacesLieWithinTheirErrorsAndFaceOutwards) {
    const auto [scale, offset_bits] = GetParam();
    const Spawned spawned = spawn_at(scale, offset_bits, 3);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < spawned.results.size(); ++i) {
        const SpawnResult &result = spawned.results[i];
        if (!result.first.hit) continue;
        ++hits;
        const Sphere &sphere = spawned.spheres[i];
        const Ray &ray = spawned.rays[i];
        const Vector n = result.surface.geometric, from_center = Vector(result.surface.p) - Vector(sphere.center);
        const real allowed = dot(Vector(glm::abs(result.surface.geometric)), result.surface.error);
        ASSERT_LE(std::abs(length(from_center) - sphere.radius), allowed) << i;
        ASSERT_LE(allowed, 0x1p-18L * (length(Vector(sphere.center)) + sphere.radius)) << "the bound is no use if it is wide";
        const Vector f = Vector(ray.origin) - Vector(sphere.center);
        const real error = 8 * unit_roundoff * (length(f) + result.first.t) / sphere.radius + 4 * unit_roundoff;
        ASSERT_LE(length(n - unit(f + Vector(ray.direction) * result.first.t)), error) << i;
        ASSERT_LE(std::abs(length(n) - 1), 4 * unit_roundoff);
        ASSERT_EQ(result.surface.normal, result.surface.geometric);
    }
    EXPECT_GT(hits, count / 8);
}

/// Outwards nothing is met; inwards the far side, at twice the radius times the cosine.
TEST_P(SphereAtScale, RaysThatLeaveItNeverMeetItWhereTheyBegin) {
    const auto [scale, offset_bits] = GetParam();
    const Spawned spawned = spawn_at(scale, offset_bits, 4);
    std::size_t outwards = 0, inwards = 0;
    for (std::size_t i = 0; i < spawned.results.size(); ++i) {
        const SpawnResult &result = spawned.results[i];
        if (!result.first.hit) continue;
        const Sphere &sphere = spawned.spheres[i];
        const Vector n = result.surface.geometric, d = spawned.directions[i];
        const real cosine = dot(n, d);
        const real distance = length(Vector(result.origin) - Vector(sphere.center));
        if (cosine > 0) {
            ++outwards;
            ASSERT_GT(distance, sphere.radius) << "the origin of a ray that leaves outwards lies outside";
            ASSERT_FALSE(result.second.hit) << i << ": outwards, cosine " << cosine << ", t " << result.second.t;
        } else if (cosine < 0) {
            ASSERT_LT(distance, sphere.radius) << "the origin of a ray that leaves inwards lies inside";
            // Beyond the offset's size, the far side is there without doubt.
            const real offset = sphere.radius - distance, far = -2 * sphere.radius * cosine;
            if (-cosine < 0.01L + 16 * std::sqrt(offset / sphere.radius)) continue;
            ++inwards;
            ASSERT_TRUE(result.second.hit) << i << ": inwards, cosine " << cosine;
            ASSERT_LE(std::abs(result.second.t - far), 4 * offset / -cosine + 0x1p-18L * (length(Vector(sphere.center)) + sphere.radius) / -cosine)
                << i;
        }
    }
    EXPECT_GT(outwards, count / 20);
    if (offset_bits <= 10) {
        EXPECT_GT(inwards, count / 20);
    }
}

INSTANTIATE_TEST_SUITE_P(Scales, SphereAtScale,
                         testing::Values(std::pair{1e-6f, 2}, std::pair{1.0f, 2}, std::pair{1e6f, 2}, std::pair{1.0f, 10}, std::pair{1e-6f, 20},
                                         std::pair{1.0f, 20}, std::pair{1e6f, 20}));

}  // namespace
}  // namespace brandung
