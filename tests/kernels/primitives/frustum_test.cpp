/// kernels/primitives/frustum.cl and frustum_hit.cl against extended precision.
#include "kernels/primitives/frustum.h"

#include <gtest/gtest.h>

#include "tests/kernels/primitives/crossing_oracle.h"
#include "tests/kernels/primitives/crossing_probe.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {

extern const PrimitiveKind frustum_kind;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::size_t count = 100'000;

struct Frustum {
    vec3 base, apex;
    float base_radius, apex_radius;
};

std::unique_ptr<Shape> shape_of(const Frustum &f) { return make_frustum(0, f.base, f.base_radius, f.apex, f.apex_radius); }

CrossingProbe<FrustumBlock> probe_of(const std::vector<Frustum> &frusta) {
    std::vector<std::unique_ptr<Shape>> shapes;
    for (const Frustum &frustum : frusta) shapes.push_back(shape_of(frustum));
    return {frustum_kind, shapes};
}

CrossingResult crossing(const Frustum &frustum, vec3 origin, vec3 direction, float t_max = infinity) {
    return probe_of({frustum}).crossings({make_ray(origin, direction, t_max)})[0];
}

/// What the block describes, as rounded: the surface that kernels are held to.
struct Record {
    Vector center, axis;
    real half_length, radius, slope;
    bool inside_only;
    /// Distance from the axis' line to a point given from the centre, and the place along the axis, whose length is 1 only but for rounding.
    real place(Vector p) const { return dot(p, axis) / length(axis); }
    real across(Vector p) const { return length(cross(p, axis)) / length(axis); }
    real radius_at(real z) const { return radius + slope * z; }
    real size() const { return half_length + radius + std::abs(slope) * half_length; }
};
Record record_of(const std::vector<FrustumBlock> &blocks, std::size_t i) {
    const FrustumBlock &b = blocks[i / BLOCK_SIZE];
    const std::size_t j = i % BLOCK_SIZE;
    return {Vector(b.center[0][j], b.center[1][j], b.center[2][j]),
            Vector(b.axis[0][j], b.axis[1][j], b.axis[2][j]),
            b.half_length[j],
            b.radius[j],
            b.slope[j],
            b.side[j] < 0};
}

/// Roots of |x|^2 = (r + s z)^2 by cross products from the point m of the ray that is nearest to the centre.
///
/// Rounding, with u = 2^-24, f = o - c, k = 1 + s^2: the kernel's m is off by e = 4 u |f| across the ray (f, the product and the sum), its z and x by
/// 4 u |m| more, and z by 2 u |z| since the axis has unit length only but for rounding. Its coefficients of F(t) = a t^2 + 2 b t + c are off by
/// da = 12 u k d^2, db = 12 u k d (m + r) + k d e, dc = 12 u (k m^2 + r^2) + 2 k (m + r) e, so F(t) by dF = da t^2 + 2 db |t| + dc, and a root by
/// dF / |F'(t)| as long as that is small against the distance to the other root, and by sqrt(2 dF / |a|) else.
/// The sum with the nearest point's t adds 4 u (|f| / d + |t|).
std::vector<Root> roots_of(const Record &record, const Ray &ray) {
    const Vector d = ray.direction, f = Vector(ray.origin) - record.center, axis = unit(record.axis);
    const real u = unit_roundoff, dd = dot(d, d), d_length = std::sqrt(dd), nearest = -dot(f, d) / dd;
    const Vector m = f + d * nearest, dx = cross(d, axis), mx = cross(m, axis);
    const real dz = dot(d, axis), mz = dot(m, axis), s = record.slope, r = record.radius_at(mz), k = 1 + s * s;
    const real a = dot(dx, dx) - s * dz * s * dz, b = dot(mx, dx) - s * dz * r, c = dot(mx, mx) - r * r;
    const real e = 4 * u * length(f), size = length(m) + std::abs(r) + record.radius;
    const real da = 12 * u * k * dd, db = 12 * u * k * d_length * size + k * d_length * e, dc = 12 * u * k * size * size + 2 * k * size * e;
    const real discriminant = b * b - a * c, derror = 2 * std::abs(b) * db + db * db + std::abs(a) * dc + std::abs(c) * da + da * dc;
    if (discriminant < -derror) return {};

    const real root = std::sqrt(std::max(discriminant, 0.0L)), q = -(b + std::copysign(root, b));
    const real fz = dot(f, axis), fr = record.radius_at(fz), fx = length(cross(f, axis));
    const bool may_start_on = std::abs(fx * fx - fr * fr) <= 0x1p-19L * std::abs(fr) * (std::abs(fr) + std::abs(fz)) + 2 * dc;
    struct Candidate {
        real t, error;
        bool sure;
    } candidates[2];
    for (int i = 0; i < 2; ++i) {
        const real t = i == 0 ? q / a : c / q, df = da * t * t + 2 * db * std::abs(t) + dc;
        const bool apart = discriminant > derror && df * std::abs(a) < root * root / 4;
        const real error = apart ? df / root : 2 * std::sqrt((df + derror / std::abs(a)) / std::abs(a));
        candidates[i] = {nearest + t, error + 4 * u * (length(f) / d_length + std::abs(t)), apart};
    }
    std::vector<Root> roots;
    for (int i = 0; i < 2; ++i) {
        const auto [t, error, apart] = candidates[i];
        if (!std::isfinite(t)) continue;
        const real z = mz + (t - nearest) * dz, at_z = std::abs(dz) * error + 8 * u * (std::abs(z) + length(f));
        if (std::abs(z) > record.half_length + at_z) continue;
        const real radius = record.radius_at(z), at_radius = std::abs(s) * at_z + 4 * u * (record.radius + std::abs(s * z));
        if (radius < -at_radius) continue;
        const real gradient = a * (t - nearest) + b;
        if (record.inside_only && apart && gradient < 0) continue;
        const bool may_be_start = may_start_on && std::abs(t) <= std::abs(candidates[1 - i].t) + error;
        const bool sure = apart && !may_be_start && std::abs(z) < record.half_length - at_z && radius > at_radius;
        roots.push_back({t, error, sure});
    }
    return roots;
}

struct Cases {
    std::vector<Frustum> frusta;
    std::vector<Ray> rays;
};
Frustum random_frustum(Random &random, float size, int offset_bits) {
    const vec3 base = random.direction() * (size * std::exp2(random.uniform(-2, float(offset_bits))));
    for (;;) {
        const vec3 apex = base + random.direction() * size * std::exp2(random.uniform(-3, 3));
        const float base_radius = size * random.uniform(0.1f, 1);
        const uint shape = random.below(4);
        const float apex_radius = shape == 0 ? base_radius : shape == 1 ? 0.0f : size * random.uniform(0, 1);
        const float sign = random.below(5) == 0 ? -1.0f : 1.0f;
        const Frustum frustum{base, apex, sign * base_radius, sign * apex_radius};
        if (shape_of(frustum)) return frustum;
    }
}
/// Cones, cylinders and frusta of three sizes, with rays at points on and near them, from near, far, or inside.
Cases random_cases(uint seed, int offset_bits) {
    Random random(seed);
    Cases cases;
    while (cases.rays.size() < count) {
        const float size = std::exp2(float(int(random.below(3)) - 1) * 20) * random.uniform(0.5f, 1);
        const Frustum frustum = random_frustum(random, size, offset_bits);
        const float s = random.uniform(0, 1), radius = std::abs(frustum.base_radius) + s * std::abs(frustum.apex_radius - frustum.base_radius);
        const vec3 on_axis = frustum.base + s * (frustum.apex - frustum.base),
                   target = on_axis + random.direction() * (radius * random.uniform(0, 1.2f));
        const vec3 origin =
            random.below(4) == 0 ? on_axis + random.in_cube(0.3f) * radius : target + random.direction() * (size * std::exp2(random.uniform(-3, 12)));
        vec3 towards = vec3(glm::normalize(glm::dvec3(target) - glm::dvec3(origin)));
        if (random.below(8) == 0) towards = vec3(glm::normalize(glm::dvec3(frustum.apex) - glm::dvec3(frustum.base)));
        if (!(glm::length(towards) > 0)) continue;
        const vec3 direction = random.below(4) == 0 ? towards * std::exp2(random.uniform(-8, 8)) : towards;
        const float t_max = random.below(4) == 0 ? glm::length(target - origin) / glm::length(direction) : infinity;
        cases.frusta.push_back(frustum);
        cases.rays.push_back(make_ray(origin, direction, t_max));
    }
    return cases;
}

const Frustum cylinder = {{0, 0, -1}, {0, 0, 1}, 1, 1}, cone = {{0, 0, -1}, {0, 0, 1}, 1, 0};

TEST(Frustum, CrossingIsTheNearerOneThatIsBetweenTheEnds) {
    EXPECT_EQ(crossing(cylinder, {-3, 0, 0}, {1, 0, 0}).t, 2);
    EXPECT_EQ(crossing(cylinder, {0, 0, 0}, {1, 0, 0}).t, 1);
    EXPECT_EQ(crossing(cylinder, {-3, 0, 3.5f}, {1, 0, -1}).t, 4) << "over the rim, onto the far wall";
    EXPECT_EQ(crossing(cone, {-3, 0, 0}, {1, 0, 0}).t, 2.5f);
    EXPECT_EQ(crossing(cone, {-3, 0, 0}, {2, 0, 0}).t, 1.25f);
}

TEST(Frustum, EndsAreOpenAndTheOtherNappeIsNotThere) {
    EXPECT_FALSE(crossing(cylinder, {0.5f, 0, -3}, {0, 0, 1}).hit);
    EXPECT_FALSE(crossing(cylinder, {-3, 0, 1.001f}, {1, 0, 0}).hit);
    EXPECT_FALSE(crossing(cone, {-3, 0, 1.5f}, {1, 0, 0}).hit);
    EXPECT_EQ(crossing(cone, {0.5f, 0, -3}, {0, 0, 1}).t, 3) << "from below, parallel to the axis";
}

TEST(Frustum, NothingIsMetBehindBesideOrBeyondTheRaysEnd) {
    EXPECT_FALSE(crossing(cylinder, {3, 0, 0}, {1, 0, 0}).hit);
    EXPECT_FALSE(crossing(cylinder, {-3, 1.001f, 0}, {1, 0, 0}).hit);
    EXPECT_FALSE(crossing(cylinder, {-3, 0, 0}, {1, 0, 0}, 1.999f).hit);
    EXPECT_TRUE(crossing(cylinder, {-3, 0, 0}, {1, 0, 0}, 2).hit);
}

TEST(Frustum, OfNegativeRadiusOnlyTheInsideIsSeen) {
    const Frustum inside = {{0, 0, -1}, {0, 0, 1}, -1, -1};
    EXPECT_EQ(crossing(inside, {-3, 0, 0}, {1, 0, 0}).t, 4);
    EXPECT_EQ(crossing(inside, {0, 0, 0}, {1, 0, 0}).t, 1);
    EXPECT_FALSE(crossing(inside, {-3, 0, 0}, {1, 0, 0}, 3.5f).hit);
}

TEST(Frustum, ARayAlongTheSideOfAConeMeetsItOnlyBeyond) {
    // Parallel to the line on which it would be tangent: the quadratic's leading coefficient is 0.
    const CrossingResult result = crossing({{0, 0, -1}, {0, 0, 1}, 2, 0}, {-2, 0, 0}, {1, 0, -1});
    ASSERT_TRUE(result.hit);
    EXPECT_EQ(result.t, 0.5f);  // x = -2 + t, z = -t, radius 1 - z = 1 + t: 2 - t = 1 + t
}

TEST(Frustum, CrossingsAreWhatRoundingExplains) {
    for (const int offset_bits : {2, 10, 20}) {
        const Cases cases = random_cases(uint(offset_bits), offset_bits);
        const CrossingProbe<FrustumBlock> probe = probe_of(cases.frusta);
        const std::vector<CrossingResult> results = probe.crossings(cases.rays);
        std::size_t sure = 0, bad = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const std::vector<Root> roots = roots_of(record_of(probe.blocks(), i), cases.rays[i]);
            sure += sure_hits(roots, cases.rays[i].t_max);
            const testing::AssertionResult result = explains(roots, results[i], cases.rays[i].t_max);
            if (!result && ++bad <= 3) ADD_FAILURE() << "case " << i << " of offset 2^" << offset_bits << ": " << result.message();
        }
        EXPECT_EQ(bad, 0u) << "offset 2^" << offset_bits;
        EXPECT_GT(sure, count / 4) << "offset 2^" << offset_bits;
    }
}

TEST(Frustum, AllWidthsGiveTheSameBits) {
    Random random(2);
    std::vector<Frustum> frusta;
    std::vector<Ray> rays;
    while (rays.size() < count / 16 * 16) {
        const float size = std::exp2(random.uniform(-20, 20));
        const vec3 center = random.in_cube(16) * size;
        for (int i = 0; i < 16; ++i) {
            Frustum frustum;
            do {
                frustum = random_frustum(random, size, 0);
                frustum.base += center, frustum.apex += center;
            } while (!shape_of(frustum));
            frusta.push_back(frustum);
            const vec3 origin = center + random.in_cube(4) * size, target = center + random.in_cube(0.5f) * size;
            rays.push_back(make_ray(origin, (target - origin) * std::exp2(random.uniform(-4, 4)), random.below(4) ? infinity : 1.0f));
        }
    }
    const WidthResult result = probe_of(frusta).compare_widths(rays);
    EXPECT_GT(result.hits, count / 2);
    EXPECT_EQ(result.different_8, 0u);
    EXPECT_EQ(result.different_16, 0u);
}

class FrustumAtScale : public testing::TestWithParam<std::pair<float, int>> {};

struct Spawned {
    std::vector<Record> records;
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
real distance_from(const Record &record, Vector p) {
    return (record.across(p) - record.radius_at(record.place(p))) / std::sqrt(1 + record.slope * record.slope);
}

/// The true normal at a point given from the centre.
Vector normal_at(const Record &record, Vector p) {
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
        const Record &record = spawned.records[i];
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
        const Record &record = spawned.records[i];
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

TEST(Frustum, TheTipHasANormal) {
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
