/// Which crossings with a disk count, kernels/primitives/disk_hit.cl. How right they are is the self-test's matter.
#include "kernels/primitives/disk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "runtime/selftest/extended.h"
#include "tests/kernels/primitives/crossing_probe.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {

extern const PrimitiveKind disk_kind;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::size_t count = 100'000;

struct Disk {
    vec3 center, normal;
    float radius;
};

CrossingProbe<DiskBlock> probe_of(const std::vector<Disk> &disks) {
    std::vector<std::unique_ptr<Shape>> shapes;
    for (const Disk &disk : disks) shapes.push_back(make_disk(0, disk.center, disk.normal, disk.radius));
    return {disk_kind, shapes};
}

CrossingResult crossing(const Disk &disk, vec3 origin, vec3 direction, float t_max = infinity) {
    return probe_of({disk}).crossings({make_ray(origin, direction, t_max)})[0];
}

const Disk disk = {{0, 0, 5}, {0, 0, -2}, 1};

/// The disk's normal as it is stored.
Vector stored_normal(const Disk &disk) { return vec3(glm::normalize(glm::dvec3(disk.normal))); }

TEST(Disk, IsMetFromBothSides) {
    EXPECT_EQ(crossing(disk, {0, 0, 0}, {0, 0, 1}).t, 5);
    EXPECT_EQ(crossing(disk, {0.5f, 0, 7}, {0, 0, -1}).t, 2);
    EXPECT_EQ(crossing(disk, {0, 0, 0}, {0, 0, 2}).t, 2.5f);
    EXPECT_EQ(crossing(disk, {-5, 0.5f, 0}, {1, 0, 1}).t, 5);
}

TEST(Disk, EndsAtItsRim) {
    EXPECT_TRUE(crossing(disk, {1, 0, 0}, {0, 0, 1}).hit) << "the rim is of it";
    EXPECT_FALSE(crossing(disk, {std::nextafter(1.0f, 2.0f), 0, 0}, {0, 0, 1}).hit);
    EXPECT_TRUE(crossing(disk, {0.6f, 0.79999f, 0}, {0, 0, 1}).hit);
    EXPECT_FALSE(crossing(disk, {0.6f, 0.80001f, 0}, {0, 0, 1}).hit) << "though in its box";
}

TEST(Disk, NothingIsMetBehindBesideOrBeyondTheRaysEnd) {
    EXPECT_FALSE(crossing(disk, {0, 0, 7}, {0, 0, 1}).hit);
    EXPECT_FALSE(crossing(disk, {0, 0, 0}, {0, 0, 1}, 4.999f).hit);
    EXPECT_TRUE(crossing(disk, {0, 0, 0}, {0, 0, 1}, 5).hit);
    EXPECT_FALSE(crossing(disk, {0, 0, 5}, {0, 0, 1}).hit) << "it begins on it";
    EXPECT_FALSE(crossing(disk, {-3, 0, 5}, {1, 0, 0}).hit) << "it lies in its plane";
    EXPECT_FALSE(crossing(disk, {-3, 0, 4.9999f}, {1, 0, 0}).hit) << "it is parallel to that";
}

TEST(Disk, ARayThatLeavesItDoesNotMeetItAgain) {
    Ray ray = make_ray({0, 0, 4.999f}, {0, 0, 1});
    EXPECT_TRUE(probe_of({disk}).crossings({ray})[0].hit);
    ray.tag = RAY_TAG(RAY_REFLECTED, 0);
    EXPECT_FALSE(probe_of({disk}).crossings({ray})[0].hit);
}

/// Origins up to 2^-34 radii near to the plane, and directions that come as near to it: t has nearly all of its digits there too.
TEST(Disk, TIsRightHoweverFlatARayMeetsIt) {
    Random random(9);
    std::vector<Disk> disks;
    std::vector<Ray> rays;
    std::vector<long double> expected;
    while (rays.size() < count) {
        const float radius = std::exp2(random.uniform(-15, 15));
        const Disk disk = {random.direction() * radius, random.direction(), radius};
        const glm::dvec3 n(disk.normal), x = glm::normalize(glm::cross(n, glm::dvec3(random.direction())));
        const float height = std::exp2(random.uniform(-34, -2)) * (random.below(2) ? 1.0f : -1.0f), part = random.uniform(0, 0.5f);
        const vec3 origin = vec3(glm::dvec3(disk.center) + double(radius) * (double(part) * x + double(height) * n));
        const vec3 aside = vec3(glm::normalize(glm::cross(n, glm::dvec3(random.direction()))));
        const vec3 direction = glm::normalize(aside + disk.normal * (4 * height * (random.below(2) ? 1.0f : -1.0f)));
        const Vector normal = stored_normal(disk);
        const long double rate = dot(direction, normal), above = dot(Vector(origin) - Vector(disk.center), normal), t = -above / rate;
        if (std::abs(above) < 0x1p-36L * radius || std::abs(rate) < 0x1p-36L) continue;  // floats of the origin and direction have none
        if (std::abs(std::abs(t) - radius / 2) > 0.45L * radius) continue;               // beyond the rim perhaps
        if (double(length(Vector(origin) + Vector(direction) * t - Vector(disk.center))) > 0.999 * radius) continue;
        disks.push_back(disk), rays.push_back(make_ray(origin, direction)), expected.push_back(t);
    }
    const std::vector<CrossingResult> results = probe_of(disks).crossings(rays);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(results[i].hit, expected[i] > 0) << i << ": t " << expected[i];
        if (!results[i].hit) continue;
        ++hits;
        // Of heights and rates of 2^-36 a part of 2^-44 is 2^-8: but such are rare.
        const long double above = absolute(dot(Vector(rays[i].origin) - Vector(disks[i].center), stored_normal(disks[i])));
        const long double rate = absolute(dot(Vector(rays[i].direction), stored_normal(disks[i])));
        ASSERT_NEAR(results[i].t / expected[i], 1, 4 * unit_roundoff + 0x1p-44L * (disks[i].radius / above + 1 / rate)) << i;
    }
    EXPECT_GT(hits, count / 4);
    EXPECT_LT(hits, count * 3 / 4);
}

/// From so far away that rounding moves the place by some hundredths of the radius: the point is on the disk all the same.
TEST(DiskSurface, IsWithinTheRimHoweverFarTheRayComesFrom) {
    Random random(2);
    std::vector<std::unique_ptr<Shape>> shapes;
    std::vector<Ray> rays;
    std::vector<vec3> directions;
    for (std::size_t i = 0; i < 4096; ++i) {
        shapes.push_back(make_disk(0, {0, 0, 0}, {0, 0, 1}, 1));
        const vec3 from = random.direction() * 0x1p20f, rim = glm::normalize(vec3(from.y, -from.x, 0));
        rays.push_back(make_ray(from, vec3(glm::normalize(glm::dvec3(rim) - glm::dvec3(from)))));
        directions.push_back({0, 0, 1});
    }
    std::size_t hits = 0;
    for (const SpawnResult &result : CrossingProbe<DiskBlock>(disk_kind, shapes).spawned(rays, directions)) {
        if (!result.first.hit) continue;
        ++hits;
        EXPECT_LT(glm::length(result.surface.p), 1 + 1e-6f);
        EXPECT_EQ(result.surface.p.z, 0);
        EXPECT_EQ(result.surface.geometric, vec3(0, 0, 1));
        EXPECT_FALSE(result.second.hit);
    }
    EXPECT_GT(hits, 1000u);
    EXPECT_LT(hits, 3500u);
}

}  // namespace
}  // namespace brandung
