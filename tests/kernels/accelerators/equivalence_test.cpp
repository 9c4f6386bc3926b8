/// Every accelerator finds what `none` finds, bit for bit: no hit is lost, ties go to the lower number, single rays and packets agree.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>

#include "scene/accelerators/accelerator.h"
#include "tests/kernels/accelerators/hard_scenes.h"
#include "tests/support/primitives.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {
namespace {

/// Rays, and the instances of what they leave.
struct Query {
    std::vector<Ray> rays;
    std::vector<uint> sources = {0};
};

/// Hits, and the instances that they are in.
struct Found {
    std::vector<Hit> hits;
    std::vector<uint> instances;
};

/// One ray after another.
Found find(TracedScene &traced, const Query &query) {
    traced.leave_instances(query.sources);
    const std::vector<Hit> hits = traced.closest_hits(query.rays);
    return {hits, traced.instances()};
}

bool same_bits(const Hit &a, const Hit &b) { return std::memcmp(&a, &b, sizeof(Hit)) == 0; }

std::string text(const Hit &hit) { return "{t " + std::to_string(hit.t) + ", primitive " + std::to_string(int(hit.primitive)) + "}"; }

void expect_same(const Found &found, const Found &expected, const std::vector<Ray> &rays, const std::string &what) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (same_bits(found.hits[i], expected.hits[i]) && found.instances[i] == expected.instances[i]) continue;
        if (++different <= 3)
            ADD_FAILURE() << what << ": ray " << i << ": " << text(found.hits[i]) << " in " << found.instances[i] << " instead of "
                          << text(expected.hits[i]) << " in " << expected.instances[i] << std::hexfloat << ", origin " << rays[i].origin.x << ' '
                          << rays[i].origin.y << ' ' << rays[i].origin.z << ", direction " << rays[i].direction.x << ' ' << rays[i].direction.y << ' '
                          << rays[i].direction.z;
    }
    EXPECT_EQ(different, 0u) << what << ", of " << rays.size();
}

/// Rays that begin where others hit, exactly there or beyond the point's error bound; some say that they leave what was hit.
Query continued(TracedScene &traced, const std::vector<Ray> &rays, const Found &found) {
    Random random(8);
    const std::vector<Hit> &hits = found.hits;
    const std::vector<Surface> surfaces = traced.surfaces(rays, hits, found.instances);
    Query result{{}, {}};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hits[i].primitive == NO_HIT) continue;
        const Surface &surface = surfaces[i];
        const vec3 offset = surface.geometric * glm::dot(glm::abs(surface.geometric), surface.error);
        const vec3 shift = random.below(2) ? vec3(0) : offset * (random.below(2) ? 2.0f : -2.0f);
        result.rays.push_back(make_ray(surface.p + shift, random.direction(), INFINITY, RAY_REFLECTED));
        if (random.below(2)) result.rays.back().tag = RAY_TAG(RAY_REFLECTED, hits[i].primitive);
        result.sources.push_back(found.instances[i]);
    }
    return result;
}

/// Rays that end at their hit, or at the float before.
std::vector<Ray> cut_at_hit(const std::vector<Ray> &rays, const std::vector<Hit> &hits) {
    std::vector<Ray> result = rays;
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (hits[i].primitive != NO_HIT) result[i].t_max = i % 2 ? hits[i].t : std::nextafter(hits[i].t, 0.0f);
    return result;
}

std::size_t count_hits(const std::vector<Hit> &hits) {
    return std::size_t(std::count_if(hits.begin(), hits.end(), [](const Hit &hit) { return hit.primitive != NO_HIT; }));
}

void expect_equivalent(Scene &scene, const std::string &accelerator, const Query &query, const Found &expected, const std::string &what) {
    TracedScene traced(scene, accelerator);
    const std::vector<Ray> &rays = query.rays;
    traced.leave_instances(query.sources);
    const std::size_t hits = count_hits(expected.hits);
    for (const Traversal &traversal : traced.traversals()) {
        const std::vector<Hit> found = traced.closest_hits(traversal, rays);
        expect_same({found, traced.instances()}, expected, rays, what + ", " + traversal.name);
        EXPECT_EQ(std::accumulate(traced.tally().rays, traced.tally().rays + RAY_KINDS, std::size_t{0}), rays.size());
        EXPECT_EQ(std::accumulate(traced.tally().hits, traced.tally().hits + RAY_KINDS, std::size_t{0}), hits);

        const std::vector<std::uint8_t> visible = traced.visible(traversal, rays);
        std::size_t different = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) different += (visible[i] != 0) != (expected.hits[i].primitive == NO_HIT);
        EXPECT_EQ(different, 0u) << what << ", shadows, " << traversal.name << ", of " << rays.size();
        EXPECT_EQ(traced.tally().hits[RAY_SHADOW], hits) << traversal.name;
        EXPECT_EQ(traced.tally().rays[RAY_SHADOW], rays.size()) << traversal.name;
    }
}

/// Makes every scene take the same kernels: one of each kind, and an instance. They are compiled for the default accelerator without, too; for each
/// of the others that would take some seconds more.
void take_all_kernels(Scene &scene, vec3 centre) {
    Random random(14);
    Scene group = empty_scene();
    add_sphere(group, 0, vec3(0), 0.01f);
    add_group(scene, "", std::move(group.shapes));
    EXPECT_FALSE(add_instance(scene, uint(scene.groups.size() - 1), translation(centre + random.in_cube(1))));
    for (const std::string &kind : names_of_primitive_kinds()) maker_of(kind)(scene, 0, random, centre + random.in_cube(1), 0.01f);
}

bool has_kernels_of_its_own(const std::string &accelerator) { return accelerator == accelerator_kinds().front().name || accelerator == "none"; }

class Equivalence : public testing::TestWithParam<std::tuple<std::string, SceneKind>> {};

std::vector<std::string> accelerator_names() {
    std::vector<std::string> names;
    for (const AcceleratorKind &kind : accelerator_kinds()) names.push_back(kind.name);
    return names;
}

std::string name_of(const testing::TestParamInfo<Equivalence::ParamType> &info) {
    return std::get<0>(info.param) + "_" + std::get<1>(info.param).name;
}

TEST_P(Equivalence, FindsWhatNoneFinds) {
    const auto &[accelerator, kind] = GetParam();
    Scene scene = kind.make();
    if (!has_kernels_of_its_own(accelerator)) take_all_kernels(scene, kind.centre);
    const Query query{make_rays(scene, kind.centre)};
    TracedScene none(scene, "none");
    const Found expected = find(none, query);
    EXPECT_GT(count_hits(expected.hits), 500u);
    expect_equivalent(scene, accelerator, query, expected, "rays");

    const Query from_surfaces = continued(none, query.rays, expected);
    expect_equivalent(scene, accelerator, from_surfaces, find(none, from_surfaces), "rays from surfaces");

    const Query cut{cut_at_hit(query.rays, expected.hits)};
    const Found found = find(none, cut);
    for (std::size_t i = 1; i < cut.rays.size(); i += 2)
        ASSERT_TRUE(same_bits(found.hits[i], expected.hits[i])) << "a ray meets what lies at its t_max";
    expect_equivalent(scene, accelerator, cut, found, "rays cut at their hit");
}

INSTANTIATE_TEST_SUITE_P(Accelerators, Equivalence, testing::Combine(testing::ValuesIn(accelerator_names()), testing::ValuesIn(scene_kinds())),
                         name_of);

class EquivalenceOfHighQuality : public testing::TestWithParam<SceneKind> {};

TEST_P(EquivalenceOfHighQuality, FindsWhatNoneFinds) {
    const SceneKind &kind = GetParam();
    Scene scene = kind.make();
    scene.accelerator_quality = BuildQuality::high;
    const Query query{make_rays(scene, kind.centre)};
    TracedScene none(scene, "none");
    expect_equivalent(scene, "wide_bvh", query, find(none, query), "rays");
}

INSTANTIATE_TEST_SUITE_P(Accelerators, EquivalenceOfHighQuality, testing::ValuesIn(scene_kinds()), [](const auto &info) { return info.param.name; });

/// Every fifth ray gets something that is no finite number: a component of its origin or direction, or its end.
std::vector<Ray> broken(std::vector<Ray> rays) {
    for (std::size_t i = 3, k = 0; i < rays.size(); i += 5, ++k) {
        const float values[] = {NAN, INFINITY, -INFINITY};
        const auto axis = glm::length_t(k / 3 % 3);
        if (k / 9 % 3 == 0) rays[i].origin[axis] = values[k % 3];
        if (k / 9 % 3 == 1) rays[i].direction[axis] = values[k % 3];
        if (k / 9 % 3 == 2) rays[i].t_max = k % 3 == 0 ? NAN : -1.0f;
    }
    return rays;
}

class EquivalenceOfBrokenRays : public testing::TestWithParam<SceneKind> {};

/// They meet nothing, and those beside them what they meet without.
TEST_P(EquivalenceOfBrokenRays, HideNothingFromTheirNeighbours) {
    const SceneKind &kind = GetParam();
    Scene scene = kind.make();
    TracedScene none(scene, "none");
    const std::vector<Ray> rays = make_rays(scene, kind.centre);
    Query query{broken(rays)};
    Found expected = find(none, Query{rays});
    for (std::size_t i = 3; i < rays.size(); i += 5) expected.hits[i] = {query.rays[i].t_max, 0.0f, 0.0f, NO_HIT}, expected.instances[i] = 0;
    EXPECT_GT(count_hits(expected.hits), 500u);
    for (const std::string accelerator : {"none", "wide_bvh"}) expect_equivalent(scene, accelerator, query, expected, accelerator);
}

INSTANTIATE_TEST_SUITE_P(Accelerators, EquivalenceOfBrokenRays, testing::ValuesIn(scene_kinds()), [](const auto &info) { return info.param.name; });

TEST(EquivalenceOfNone, TiesGoToTheLowerNumberAcrossKinds) {
    Scene scene = duplicates();
    TracedScene none(scene, "none");
    const std::vector<Ray> rays = make_rays(scene, vec3(0));
    const uint group = uint(primitive_kinds().size()), distinct = group + group * 60;
    uint hits_count = 0;
    for (const Hit &hit : none.closest_hits(rays)) {
        if (hit.primitive == NO_HIT) continue;
        ++hits_count;
        ASSERT_LT(hit.primitive, distinct) << "a copy was hit, not the first of its kind";
        // In every group the second is the first one's triangle again, as a smooth one.
        ASSERT_FALSE(hit.primitive >= group && hit.primitive % group == 1) << "the smooth copy of a flat triangle was hit";
    }
    EXPECT_GT(hits_count, 500u);
}

}  // namespace
}  // namespace brandung
