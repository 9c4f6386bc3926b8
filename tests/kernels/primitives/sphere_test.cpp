/// Which crossings with a sphere count, kernels/primitives/sphere_hit.cl. How right they are is the self-test's matter.
#include "kernels/primitives/sphere.h"

#include <gtest/gtest.h>

#include "runtime/selftest/extended.h"
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
        const long double r = spheres[i].radius, a = dot(d, d), b = dot(f, d), c = dot(f, f) - r * r;
        if (std::abs(b) < 0x1p-6L * r || b * b - a * c < 0x1p-12L * r * r) continue;  // grazing
        const long double q = b < 0 ? -b + std::sqrt(b * b - a * c) : -b - std::sqrt(b * b - a * c);
        const long double t = c > 0 ? c / q : std::max(c / q, q / a);
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

}  // namespace
}  // namespace brandung
