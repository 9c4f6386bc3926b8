/// Every accelerator finds what `none` finds, bit for bit: no hit is lost, ties go to the lower number, single rays and packets agree.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numeric>
#include <string>

#include "scene/accelerators/accelerator.h"
#include "tests/support/primitives.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// One of each kind, small: so all scenes but those of spheres alone have one set of programs.
void add_one_of_each_kind(Scene &scene) { add_soup(scene, 0, {.of_each = 1, .size = 0.01f}); }

Scene empty_scene() {
    Scene scene;
    add_material(scene, matte(0.5f));
    return scene;
}

Scene soup_scene(const Soup &soup) {
    Scene scene = empty_scene();
    add_one_of_each_kind(scene);
    add_soup(scene, 0, soup);
    return scene;
}

Scene spheres_only() {
    Scene scene = empty_scene();
    add_soup(scene, 0, {.counts = {{"sphere", 300}}, .size = 0.3f});
    return scene;
}
Scene one_sphere() {
    Scene scene = empty_scene();
    add_sphere(scene, 0, {0.1f, 0.2f, 0.3f}, 0.7f);
    return scene;
}
Scene mixture() { return soup_scene({.of_each = 150, .size = 0.4f}); }

/// Three times the same, in an order that separates equals; triangles also as smooth ones. Groups have one of each kind, and first these two.
Scene duplicates() {
    Scene scene = empty_scene();
    add_one_of_each_kind(scene);
    for (uint copy = 0; copy < 3; ++copy) {
        Random random(5);
        for (uint i = 0; i < 60; ++i) {
            const vec3 a = random.in_cube(1), b = a + random.in_cube(0.5f), c = a + random.in_cube(0.5f);
            add_triangle(scene, 0, a, b, c);
            add_smooth_triangle(scene, 0, a, b, c, a - b);
            for (const std::string &kind : names_of_primitive_kinds())
                if (kind != "triangle" && kind != "smooth_triangle") maker_of(kind)(scene, 0, random, a, 0.2f);
        }
    }
    return scene;
}

/// Everything touches planes of the grid with spacing 1/4, where boxes then have their sides.
Scene grid() {
    Scene scene = empty_scene();
    add_one_of_each_kind(scene);
    for (int x = -4; x < 4; ++x)
        for (int y = -4; y < 4; ++y)
            for (int z = -4; z < 4; z += 2) {
                const vec3 p = 0.25f * vec3(x, y, z);
                if ((x + y) % 3 == 0) add_sphere(scene, 0, p + 0.125f, 0.125f);
                if ((x + y) % 3 == 1) add_triangle(scene, 0, p, p + vec3(0.25f, 0, 0), p + vec3(0, 0.25f, 0));
                if ((x + y) % 3 == 2) add_frustum(scene, 0, p + vec3(0.125f, 0.125f, 0), 0.125f, p + vec3(0.125f, 0.125f, 0.25f), 0.125f);
            }
    return scene;
}

/// Far from the origin, where a unit in the last place is 2^-11 of a primitive.
Scene far_away() {
    Scene scene = empty_scene();
    Random random(6);
    const vec3 centre(8192, -8192, 8192);
    for (uint i = 0; i < 100; ++i)
        for (const std::string &kind : names_of_primitive_kinds()) maker_of(kind)(scene, 0, random, centre + random.in_cube(1), 0.3f);
    return scene;
}

constexpr vec3 eye(0, 0, 3);  // from the centre

/// Nearly edge on as seen from the eye: there t is worst conditioned.
Scene edge_on() {
    Scene scene = empty_scene();
    add_one_of_each_kind(scene);
    Random random(9);
    for (uint i = 0; i < 300; ++i) {
        const vec3 a = random.in_cube(1), away = glm::normalize(a - eye);
        const float thin = std::exp2(random.uniform(-20, -6));
        const vec3 b = a + 0.5f * away + random.in_cube(thin), c = a + 0.3f * away + random.in_cube(thin);
        if (i % 3 == 0) add_triangle(scene, 0, a, b, c);
        if (i % 3 == 1) add_smooth_triangle(scene, 0, a, b, c, vec3(0));
        if (i % 3 == 2) add_frustum(scene, 0, a, thin, b, 2 * thin);
    }
    return scene;
}

/// Groups of every kind, of sizes from 1e-3 to 1e3, brought to about 1 by instances: turned, stretched, mirrored; every fourth instance twice.
Scene instances() {
    Scene scene = empty_scene();
    add_soup(scene, 0, {.of_each = 5, .size = 0.4f});
    Random random(11);
    for (const float size : {1e-3f, 1.0f, 1e3f}) {
        Scene group = empty_scene();
        for (uint i = 0; i < 10; ++i)
            for (const std::string &kind : names_of_primitive_kinds()) maker_of(kind)(group, 0, random, size * random.in_cube(1), 0.5f * size);
        add_group(scene, "", std::move(group.shapes));
    }
    for (uint i = 0; i < 48; ++i) {
        const uint group = i % 3;
        const float size = group == 0 ? 1e-3f : group == 1 ? 1.0f : 1e3f;
        glm::dvec3 factors;
        for (int axis = 0; axis < 3; ++axis) factors[axis] = std::exp2(random.uniform(-3, -1)) / size * (random.below(2) ? 1 : -1);
        AffineMap map = scaling(factors);
        if (i % 5 != 0)
            map = then(rotation(random.uniform(-180, 180), random.direction()), then(map, rotation(random.uniform(0, 360), random.direction())));
        map = then(map, translation(random.in_cube(1)));
        for (uint copy = 0; copy < (i % 4 == 0 ? 2u : 1u); ++copy) EXPECT_FALSE(add_instance(scene, group, map));
    }
    return scene;
}

/// Small triangles in layers, every other one sheared flat by its instance: the rounding of a ray that comes from afar is then some 100 times
/// larger than the boxes are grown, so that hits lie before the boxes that they are in, and before other layers.
Scene sheared_layers() {
    Scene scene = empty_scene();
    add_soup(scene, 0, {.of_each = 1, .size = 0.01f});
    const float shear = 1e5f, size = 0.05f;
    Scene group = empty_scene();
    add_triangle(group, 0, {-size, -size, shear * size}, {size, -size, -shear * size}, {0, size, 0});
    add_group(scene, "", std::move(group.shapes));
    for (uint layer = 0; layer < 20; ++layer) {
        const float z = 0.002f * float(layer);
        const AffineMap map{{{1, 0, shear}, {0, 1, 0}, {0, 0, 1}}, {0, 0, z}};
        if (layer % 2) {
            add_triangle(scene, 0, {-size, -size, z}, {size, -size, z}, {0, size, z});
        } else {
            EXPECT_FALSE(add_instance(scene, 0, map));
        }
    }
    return scene;
}

struct SceneKind {
    std::string name;
    std::function<Scene()> make;
    vec3 centre;
};
void PrintTo(const SceneKind &kind, std::ostream *out) { *out << kind.name; }

/// Some by hand, and one of each kind of primitive.
std::vector<SceneKind> scene_kinds() {
    std::vector<SceneKind> kinds = {
        {"spheres_only", spheres_only, {}},
        {"one_sphere", one_sphere, {}},
        {"mixture", mixture, {}},
        {"duplicates", duplicates, {}},
        {"grid", grid, {}},
        {"edge_on", edge_on, {}},
        {"far_away", far_away, {8192, -8192, 8192}},
        {"instances", instances, {}},
        {"sheared_layers", sheared_layers, {3, 0, 0}},
    };
    for (const std::string &name : names_of_primitive_kinds())
        kinds.push_back({"only_" + name, [name] { return soup_scene({.counts = {{name, 400}}, .size = 0.4f}); }, {}});
    return kinds;
}

std::vector<Bounds> boxes_of(const Scene &scene) {
    std::vector<Bounds> boxes;
    for (const auto &shape : scene.shapes)
        for (std::size_t i = 0; i < shape->count(); ++i) boxes.push_back(shape->bounds(i));
    for (const PlacedGroup &instance : scene.instances) boxes.push_back(instance.bounds);
    return boxes;
}

vec3 axis(uint i, float sign) {
    vec3 d(std::copysign(0.0f, sign));
    d[int(i)] = sign;
    return d;
}

/// Rays of every sort that has made an accelerator lose hits somewhere.
std::vector<Ray> make_rays(const Scene &scene, vec3 centre) {
    Random random(7);
    std::vector<Ray> rays;
    const auto t_max = [&] { return random.below(4) == 0 ? random.uniform(0, 2) : infinity; };
    const std::vector<Bounds> boxes = boxes_of(scene);
    const auto box = [&]() -> const Bounds & { return boxes[random.below(uint(boxes.size()))]; };
    for (uint i = 0; i < 32768; ++i) rays.push_back(make_ray(centre + random.in_cube(2), random.direction(), t_max()));
    // From one point, in neighbouring directions, as camera rays are.
    for (uint i = 0; i < 4096; ++i) {
        const vec3 direction(0.02f * float(i % 64) - 0.63f, 0.02f * float(i / 64) - 0.63f, -1);
        rays.push_back(make_ray(centre + eye, vec3(glm::normalize(glm::dvec3(direction)))));
    }
    // From the eye into the boxes.
    for (uint i = 0; i < 16384; ++i) {
        const Bounds &b = box();
        const glm::dvec3 p(random.uniform(b.low.x, b.high.x), random.uniform(b.low.y, b.high.y), random.uniform(b.low.z, b.high.z));
        rays.push_back(make_ray(centre + eye, vec3(glm::normalize(p - glm::dvec3(centre + eye))), t_max()));
    }
    // Any length of the direction.
    for (uint i = 0; i < 1024; ++i)
        rays.push_back(make_ray(centre + random.in_cube(2), random.direction() * std::exp2(random.uniform(-10, 10)), t_max()));
    // Along the axes, from anywhere.
    for (uint i = 0; i < 2048; ++i)
        rays.push_back(make_ray(centre + random.in_cube(2), axis(random.below(3), random.below(2) ? 1.0f : -1.0f), t_max()));
    // In a plane of a box: along an axis or askew.
    for (uint i = 0; i < 4096; ++i) {
        const Bounds &b = box();
        const int a = int(random.below(3));
        vec3 origin = centre + random.in_cube(2), direction = random.below(2) ? axis(uint(a + 1) % 3, 1) : random.direction();
        origin[a] = random.below(2) ? b.low[a] : b.high[a];
        direction[a] = random.below(2) ? 0.0f : -0.0f;
        rays.push_back(make_ray(origin, direction, t_max()));
    }
    // Through corners of boxes, and from them, along edges too.
    for (uint i = 0; i < 4096; ++i) {
        const Bounds &b = box();
        const vec3 corner(random.below(2) ? b.low.x : b.high.x, random.below(2) ? b.low.y : b.high.y, random.below(2) ? b.low.z : b.high.z);
        const vec3 direction = random.below(2) ? random.direction() : axis(random.below(3), -1);
        rays.push_back(make_ray(random.below(2) ? corner : corner - 2.0f * direction, direction, t_max()));
    }
    return rays;
}

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
        result.rays.push_back(make_ray(surface.p + shift, random.direction(), infinity, RAY_REFLECTED));
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
    expect_same(find(traced, query), expected, rays, what + ", single rays");
    const std::size_t hits = count_hits(expected.hits);
    EXPECT_EQ(std::accumulate(traced.tally().hits, traced.tally().hits + RAY_KINDS, std::size_t{0}), hits);
    const std::vector<Hit> of_packets = traced.closest_hits_of_packets(rays);
    expect_same({of_packets, traced.instances()}, expected, rays, what + ", packets");
    EXPECT_EQ(std::accumulate(traced.tally().rays, traced.tally().rays + RAY_KINDS, std::size_t{0}), rays.size());
    EXPECT_EQ(std::accumulate(traced.tally().hits, traced.tally().hits + RAY_KINDS, std::size_t{0}), hits);

    for (const char *stage : shadow_stages) {
        const std::vector<std::uint8_t> visible = traced.visible(stage, rays);
        std::size_t different = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) different += (visible[i] != 0) != (expected.hits[i].primitive == NO_HIT);
        EXPECT_EQ(different, 0u) << what << ", " << stage << ", of " << rays.size();
        EXPECT_EQ(traced.tally().hits[RAY_SHADOW], hits) << stage;
        EXPECT_EQ(traced.tally().rays[RAY_SHADOW], rays.size()) << stage;
    }
}

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
