/// Surfaces of kernels/primitives/frustum_hit.cl, and the rays that leave them, against extended precision.
#include <gtest/gtest.h>

#include <utility>

#include "tests/kernels/primitives/frustum_oracle.h"

namespace brandung {
namespace {

class FrustumAtScale : public testing::TestWithParam<std::pair<float, int>> {};

struct Spawned {
    std::vector<FrustumRecord> records;
    std::vector<Ray> rays;
    std::vector<vec3> directions;
    std::vector<SpawnResult> results;
};
/// Rays from outside, up to 100 sizes away, and from inside.
Spawned spawn_at(float scale, int offset_bits, uint seed) {
    Random random(seed);
    Spawned spawned;
    std::vector<Frustum> frusta;
    while (spawned.rays.size() < count / 4) {
        Frustum frustum = random_frustum(random, scale, offset_bits);
        frustum.base_radius = std::abs(frustum.base_radius), frustum.apex_radius = std::abs(frustum.apex_radius);
        const float s = random.below(3) == 0 ? 1 - std::exp2(-random.uniform(0, 12)) : random.uniform(0, 1);  // tips too
        const float radius = frustum.base_radius + s * (frustum.apex_radius - frustum.base_radius);
        const vec3 on_axis = frustum.base + s * (frustum.apex - frustum.base),
                   target = on_axis + random.direction() * (radius * random.uniform(0, 0.99f));
        const vec3 origin =
            random.below(2) ? on_axis + random.in_cube(0.3f) * radius : target + random.direction() * (scale * random.uniform(1, 100));
        const vec3 direction = vec3(glm::normalize(glm::dvec3(target) - glm::dvec3(origin)));
        if (!(glm::length(direction) > 0)) continue;
        frusta.push_back(frustum);
        spawned.rays.push_back(make_ray(origin, direction));
        spawned.directions.push_back(random.direction());
    }
    const CrossingProbe<FrustumBlock> probe = probe_of(frusta);
    for (std::size_t i = 0; i < frusta.size(); ++i) spawned.records.push_back(record_of(probe.blocks(), i));
    spawned.results = probe.spawned(spawned.rays, spawned.directions);
    return spawned;
}

/// Signed distance to the cone of which the frustum is a part, positive outside, of a point given from the centre.
real distance_from(const FrustumRecord &record, Vector p) {
    return (record.across(p) - record.radius_at(record.place(p))) / std::sqrt(1 + record.slope * record.slope);
}

/// The true normal at a point given from the centre.
Vector normal_at(const FrustumRecord &record, Vector p) {
    const Vector axis = unit(record.axis);
    return unit(unit(p - axis * dot(p, axis)) - axis * record.slope);
}

/// The point that is put back, o + t d - c, is off by 8 u (|f| + t), and its direction from the axis by that over its distance from the axis.
TEST_P(FrustumAtScale, SurfacesLieWithinTheirErrorsAndFaceOutwards) {
    const auto [scale, offset_bits] = GetParam();
    const Spawned spawned = spawn_at(scale, offset_bits, 3);
    std::size_t hits = 0, bad = 0;
    for (std::size_t i = 0; i < spawned.results.size(); ++i) {
        const SpawnResult &result = spawned.results[i];
        if (!result.first.hit) continue;
        ++hits;
        const FrustumRecord &record = spawned.records[i];
        const Ray &ray = spawned.rays[i];
        const Vector p = Vector(result.surface.p) - record.center;
        const real allowed = dot(Vector(glm::abs(result.surface.geometric)), result.surface.error), off = distance_from(record, p);
        if (!(std::abs(off) <= allowed) && ++bad <= 3)
            ADD_FAILURE() << i << ": " << off << " off the surface, said to be at most " << allowed << "; radius there " << record.across(p)
                          << ", size " << record.size() << ", slope " << record.slope << ", ray's length " << result.first.t;
        ASSERT_LE(allowed, 0x1p-18L * (length(record.center) + record.size())) << "the bound is no use if it is wide";
        const Vector f = Vector(ray.origin) - record.center, there = f + Vector(ray.direction) * result.first.t;
        const real error = 16 * unit_roundoff * (length(f) + result.first.t) / record.across(there) + 8 * unit_roundoff;
        if (error > 0.5L) continue;  // at the tip, as far as one can see from there
        if (!(length(Vector(result.surface.geometric) - normal_at(record, there)) <= error) && ++bad <= 3)
            ADD_FAILURE() << i << ": normal off by " << length(Vector(result.surface.geometric) - normal_at(record, there)) << ", more than "
                          << error;
        ASSERT_EQ(result.surface.normal, result.surface.geometric);
    }
    EXPECT_EQ(bad, 0u) << "of " << hits;
    EXPECT_GT(hits, count / 16);
}

/// The frustum's hull is convex: outwards nothing is met. Inwards, whatever is met is a root beyond the beginning.
TEST_P(FrustumAtScale, RaysThatLeaveItNeverMeetItWhereTheyBegin) {
    const auto [scale, offset_bits] = GetParam();
    const Spawned spawned = spawn_at(scale, offset_bits, 4);
    std::size_t outwards = 0, inwards = 0, bad = 0;
    for (std::size_t i = 0; i < spawned.results.size(); ++i) {
        const SpawnResult &result = spawned.results[i];
        if (!result.first.hit) continue;
        const FrustumRecord &record = spawned.records[i];
        const Vector n = result.surface.geometric, d = spawned.directions[i], from_center = Vector(result.origin) - record.center;
        const real cosine = dot(n, d), height = distance_from(record, from_center);
        const real offset = dot(Vector(glm::abs(result.surface.geometric)), result.surface.error);
        if (std::abs(cosine) < 0x1p-12L) continue;               // the normal's own error
        if (offset > record.across(from_center) / 16) continue;  // neither side nor room inside, as far as floats can tell
        if (cosine > 0) {
            ++outwards;
            if (!(height > 0) && ++bad <= 3) ADD_FAILURE() << i << ": leaves outwards, but begins " << height << " inside";
            if (result.second.hit && ++bad <= 3)
                ADD_FAILURE() << i << ": outwards, cosine " << cosine << ", met at t " << result.second.t << ", size " << record.size() << ", slope "
                              << record.slope << ", radius there " << record.across(from_center);
        } else {
            ++inwards;
            if (!(height < 0) && ++bad <= 3) ADD_FAILURE() << i << ": leaves inwards, but begins " << height << " outside";
            bool known = !result.second.hit;
            for (const Root &root : roots_of(record, make_ray(result.origin, spawned.directions[i])))
                known |= root.t > 0 && std::abs(result.second.t - root.t) <= root.error;
            if (!known && ++bad <= 3)
                ADD_FAILURE() << i << ": inwards, cosine " << cosine << ", met at t " << result.second.t << ", size " << record.size()
                              << ", radius there " << record.across(from_center);
        }
    }
    EXPECT_EQ(bad, 0u);
    if (offset_bits <= 10) {
        EXPECT_GT(outwards, count / 40);
        EXPECT_GT(inwards, count / 40);
    }
}

INSTANTIATE_TEST_SUITE_P(Scales, FrustumAtScale,
                         testing::Values(std::pair{1e-6f, 2}, std::pair{1.0f, 2}, std::pair{1e6f, 2}, std::pair{1.0f, 10}, std::pair{1e-6f, 20},
                                         std::pair{1.0f, 20}, std::pair{1e6f, 20}));

TEST(FrustumSurface, TheTipHasANormal) {
    // Rays into the tip, from outside and along the axis from inside; whatever is met has a normal of unit length.
    std::vector<std::unique_ptr<Shape>> shapes;
    std::vector<Ray> rays;
    std::vector<vec3> directions;
    Random random(1);
    for (int i = 0; i < 64; ++i) {
        shapes.push_back(shape_of(cone));
        const vec3 d = i == 0 ? vec3(0, 0, 1) : i == 1 ? vec3(0, 0, -1) : random.direction();
        rays.push_back(make_ray(vec3(0, 0, 1) - d, d));
        directions.push_back(vec3(0, 0, 1));
    }
    const CrossingProbe<FrustumBlock> probe(frustum_kind, shapes);
    std::size_t hits = 0;
    for (const SpawnResult &result : probe.spawned(rays, directions)) {
        if (!result.first.hit) continue;
        ++hits;
        EXPECT_NEAR(glm::length(result.surface.geometric), 1, 1e-6);
    }
    EXPECT_GT(hits, 0u);
}

}  // namespace
}  // namespace brandung
