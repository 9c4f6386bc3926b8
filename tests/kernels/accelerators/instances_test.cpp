/// What rays meet in instances: what they would meet if the group's objects were in the world, and never the place that they leave.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/primitives.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {
namespace {

/// Moves what has been added so far to a group.
uint make_group(Scene &scene) { return add_group(scene, std::to_string(scene.groups.size()), std::exchange(scene.shapes, {})); }

/// Few programs: all scenes here have one of each kind, where no ray goes, in a group that is used.
void add_one_of_each_kind(Scene &scene) {
    Random random(1);
    for (const std::string &kind : names_of_primitive_kinds()) maker_of(kind)(scene, 0, random, {0, 1e4f, 0}, 1);
    ASSERT_FALSE(add_instance(scene, make_group(scene), AffineMap()));
}

std::vector<Ray> rays_towards(vec3 place, float size, uint count) {
    Random random(3);
    std::vector<Ray> rays;
    for (uint i = 0; i < count; ++i) {
        const vec3 origin = place + 4 * size * random.direction(), at = place + random.in_cube(size);
        rays.push_back(make_ray(origin, vec3(glm::normalize(glm::dvec3(at) - glm::dvec3(origin)))));
    }
    return rays;
}

vec3 applied(const AffineMap &map, vec3 p) { return vec3(map.linear * glm::dvec3(p) + map.offset); }

/// A bumpy closed mesh around the origin, with the normals of a sphere.
MeshData bumpy_mesh() {
    constexpr uint columns = 24, rows = 12;
    MeshData mesh;
    for (uint row = 0; row <= rows; ++row)
        for (uint column = 0; column < columns; ++column) {
            const double theta = M_PI * row / rows, phi = 2 * M_PI * column / columns, r = 1 + 0.1 * std::sin(3 * phi) * std::sin(theta);
            const glm::dvec3 direction(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
            mesh.positions.push_back(vec3(r * direction)), mesh.normals.push_back(vec3(direction));
        }
    for (uint row = 0; row < rows; ++row)
        for (uint column = 0; column < columns; ++column) {
            const uint a = row * columns + column, b = row * columns + (column + 1) % columns, c = a + columns, d = b + columns;
            mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
        }
    return mesh;
}

/// In the world; in a mirror the order of vertices is the other one. Normals go by the inverse transposed, and are not made unit length, so that
/// means of them go with them.
MeshData baked(MeshData mesh, const AffineMap &map) {
    for (vec3 &p : mesh.positions) p = applied(map, p);
    for (vec3 &n : mesh.normals) n = vec3(glm::inverse(glm::transpose(map.linear)) * glm::dvec3(n));
    if (glm::determinant(map.linear) < 0)
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i], mesh.indices[i + 1]);
    return mesh;
}

/// Both find the same but for rays at edges, and t, points and normals agree as far as rounding of the two ways to them lets them.
void expect_same_surfaces(Scene &instanced, Scene &in_world, vec3 place, float size) {
    TracedScene a(instanced, "wide_bvh"), b(in_world, "wide_bvh");
    const std::vector<Ray> rays = rays_towards(place, size, 8192);
    const std::vector<Hit> hits_a = a.closest_hits(rays), hits_b = b.closest_hits(rays);
    const std::vector<Surface> surfaces_a = a.surfaces(rays, hits_a, a.instances()), surfaces_b = b.surfaces(rays, hits_b, b.instances());
    uint same = 0, others = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if ((hits_a[i].primitive == NO_HIT) != (hits_b[i].primitive == NO_HIT)) ++others;
        if (hits_a[i].primitive == NO_HIT || hits_b[i].primitive == NO_HIT) continue;
        const double cosine = std::abs(glm::dot(glm::dvec3(surfaces_b[i].geometric), glm::dvec3(rays[i].direction)));
        // Each way rounds a few times, of terms as large as the place and the distance: 2^-20 of them, lengthened at grazing angles.
        const double reach = double(hits_b[i].t) + glm::length(glm::dvec3(place)) + size, tolerance = 0x1p-20 * reach;
        const bool same_place = std::abs(hits_a[i].t - hits_b[i].t) <= tolerance / cosine;
        if (!same_place || glm::dot(surfaces_a[i].geometric, surfaces_b[i].geometric) < 0.9999f) {
            ++others;  // another triangle of an edge
            continue;
        }
        ++same;
        EXPECT_GT(glm::dot(surfaces_a[i].normal, surfaces_b[i].normal), 0.9999f);
        EXPECT_LE(std::abs(glm::dot(glm::dvec3(surfaces_b[i].geometric), glm::dvec3(surfaces_a[i].p) - glm::dvec3(surfaces_b[i].p))), tolerance);
    }
    EXPECT_GT(same, 2000u);
    EXPECT_LT(others, same / 200);
}

struct Placement {
    AffineMap map;
    vec3 place;
    float size;
};

/// Of things about the origin of size 1, by rotations and one factor.
std::vector<Placement> placements() {
    std::vector<Placement> result;
    for (const float factor : {1e-3f, 1.0f, -2.5f, 1e3f}) {
        const vec3 offset = 3.0f * std::abs(factor) * vec3(1, -2, 0.5f);
        result.push_back({then(rotation(70, {1, 2, 3}), then(scaling(glm::dvec3(factor)), translation(offset))), offset, std::abs(factor)});
    }
    return result;
}

TEST(Instances, AMeshIsWhereItWouldBeInTheWorld) {
    for (const Placement &placement : placements()) {
        Scene instanced = empty_scene(), in_world = empty_scene();
        add_one_of_each_kind(instanced), add_one_of_each_kind(in_world);
        add_triangle_mesh(instanced, 0, bumpy_mesh());
        ASSERT_FALSE(add_instance(instanced, make_group(instanced), placement.map));
        add_triangle_mesh(in_world, 0, baked(bumpy_mesh(), placement.map));
        expect_same_surfaces(instanced, in_world, placement.place, placement.size);
    }
}

TEST(Instances, AStretchedMeshIsWhereItWouldBeInTheWorld) {
    const AffineMap map = then(rotation(40, {3, 1, -1}), then(scaling({2, -0.3, 1}), then(rotation(100, {0, 1, 1}), translation({1, 2, 3}))));
    Scene instanced = empty_scene(), in_world = empty_scene();
    add_one_of_each_kind(instanced), add_one_of_each_kind(in_world);
    add_triangle_mesh(instanced, 0, bumpy_mesh());
    ASSERT_FALSE(add_instance(instanced, make_group(instanced), map));
    add_triangle_mesh(in_world, 0, baked(bumpy_mesh(), map));
    expect_same_surfaces(instanced, in_world, {1, 2, 3}, 1);
}

/// A square whose shading normal n leans far away from its own, g. Stretched along x by s, normals go with (1/s, 1, 1): g = (1, 1, 0) / √2 and
/// n ~ (1, -0.8, 0) have a positive product, but (1/s, 1, 0) and (1/s, -0.8, 0) one of 1/s² - 0.8. What is shaded must not be the other side.
TEST(Instances, ShadingNormalsStayOnTheSideOfTheSurface) {
    MeshData square;
    square.positions = {{1, -1, -1}, {1, -1, 1}, {-1, 1, 1}, {-1, 1, -1}}, square.indices = {0, 2, 1, 0, 3, 2};
    square.normals = std::vector<vec3>(4, vec3(glm::normalize(glm::dvec3(1, -0.8, 0))));
    for (const double factor : {1.0, 3.0, -3.0}) {
        const AffineMap map = then(scaling({factor, 1, 1}), translation({1, 2, 3}));
        Scene instanced = empty_scene(), in_world = empty_scene();
        add_one_of_each_kind(instanced), add_one_of_each_kind(in_world);
        add_triangle_mesh(instanced, 0, square);
        ASSERT_FALSE(add_instance(instanced, make_group(instanced), map));
        add_triangle_mesh(in_world, 0, baked(square, map));
        expect_same_surfaces(instanced, in_world, {1, 2, 3}, 1);
    }
}

TEST(Instances, ASphereIsWhereItWouldBeInTheWorld) {
    for (const Placement &placement : placements()) {
        Scene instanced = empty_scene(), in_world = empty_scene();
        add_one_of_each_kind(instanced), add_one_of_each_kind(in_world);
        add_sphere(instanced, 0, {0.2f, 0.1f, -0.3f}, 0.8f);
        ASSERT_FALSE(add_instance(instanced, make_group(instanced), placement.map));
        add_sphere(in_world, 0, applied(placement.map, {0.2f, 0.1f, -0.3f}), 0.8f * placement.size);
        expect_same_surfaces(instanced, in_world, placement.place, placement.size);
    }
}

/// The world's primitives are 0, 1, ...; groups' come after them.
TEST(Instances, OfEqualHitsTheWorldsIsFirstAndThenTheEarlierInstances) {
    Scene scene = empty_scene();
    add_one_of_each_kind(scene);
    add_sphere(scene, 0, {0, 0, 0}, 1);
    add_triangle(scene, 0, {-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
    const uint group = make_group(scene);
    for (uint copy = 0; copy < 20; ++copy) ASSERT_FALSE(add_instance(scene, group, AffineMap()));  // more than share a block
    const std::vector<Ray> rays = rays_towards({0, 0, 0}, 0.6f, 4096);
    for (const char *accelerator : {"none", "wide_bvh"}) {
        TracedScene instanced(scene, accelerator);
        for (const Traversal &traversal : instanced.traversals()) {
            const std::vector<Hit> hits = instanced.closest_hits(traversal, rays);
            for (std::size_t i = 0; i < rays.size(); ++i)
                ASSERT_EQ(instanced.instances()[i], hits[i].primitive == NO_HIT ? 0u : 2u) << traversal.name << ": the first of the group";
        }
    }
    add_sphere(scene, 0, {0, 0, 0}, 1);
    for (const char *accelerator : {"none", "wide_bvh"}) {
        TracedScene with_world(scene, accelerator);
        for (const Traversal &traversal : with_world.traversals()) {
            uint on_sphere = 0;
            const std::vector<Hit> hits = with_world.closest_hits(traversal, rays);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                if (hits[i].primitive == 0) ++on_sphere;
                ASSERT_EQ(with_world.instances()[i], hits[i].primitive == NO_HIT || hits[i].primitive == 0 ? 0u : 2u) << traversal.name;
            }
            EXPECT_GT(on_sphere, 1000u) << traversal.name;
        }
    }
}

/// Two instances of a triangle: a ray that leaves the one meets the other, the same primitive, but not itself, even from before it.
TEST(Instances, ARayMeetsWhatItLeavesInAnotherInstanceOnly) {
    Scene scene = empty_scene();
    add_one_of_each_kind(scene);
    add_triangle(scene, 0, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
    const uint group = make_group(scene);
    ASSERT_FALSE(add_instance(scene, group, AffineMap()));
    ASSERT_FALSE(add_instance(scene, group, translation({0, 0, 1})));
    TracedScene traced(scene, "wide_bvh");
    const std::vector<Ray> towards(16, make_ray({0, 0, -1}, {0, 0, 1}));
    const uint triangle = traced.closest_hits(towards).at(0).primitive;
    EXPECT_EQ(traced.instances().at(0), 2u);
    std::vector<Ray> leaving = towards;
    for (Ray &ray : leaving) ray.tag = RAY_TAG(RAY_REFLECTED, triangle);
    traced.leave_instances({2});
    for (const Traversal &traversal : traced.traversals()) {
        const std::vector<Hit> hits = traced.closest_hits(traversal, leaving);
        EXPECT_EQ(hits[0].primitive, triangle);
        EXPECT_EQ(hits[0].t, 2.0f);
        EXPECT_EQ(traced.instances()[0], 3u);
    }
    for (Ray &ray : leaving) ray.t_max = 1.5f;
    for (const Traversal &traversal : traced.traversals()) EXPECT_EQ(traced.visible(traversal, leaving)[0], 1u) << traversal.name;
    traced.leave_instances({3});
    EXPECT_EQ(traced.closest_hits(leaving)[0].t, 1.0f);
    for (const Traversal &traversal : traced.traversals()) EXPECT_EQ(traced.visible(traversal, leaving)[0], 0u) << traversal.name;
}

/// The point moved by its error bound along the normal, rounded away, as kernels/core/spawn.cl does it.
vec3 moved_off(const Surface &surface, float side) {
    const vec3 offset = side * surface.geometric * glm::dot(glm::abs(surface.geometric), surface.error);
    vec3 origin = surface.p + offset;
    for (int axis = 0; axis < 3; ++axis) origin[axis] = std::nextafter(origin[axis], offset[axis] > 0 ? INFINITY : -INFINITY);
    return origin;
}

/// One primitive of every kind in an instance, at sizes from 1e-3 to 1e3, stretched and far from the origins of both spaces: rays leave it to the
/// outside, where it is convex, without saying what they leave.
TEST(Instances, RaysThatLeaveASurfaceDoNotMeetItAgain) {
    Random random(5);
    for (const float size : {1e-3f, 1.0f, 1e3f}) {
        Scene scene = empty_scene();
        std::vector<vec3> places;
        for (uint i = 0; i < 40; ++i) {
            for (const std::string &kind : names_of_primitive_kinds()) {
                maker_of(kind)(scene, 0, random, size * random.in_cube(i % 2 ? 10.0f : 0.1f), size);
                const glm::dvec3 factors(std::exp2(random.uniform(-4, 4)), -std::exp2(random.uniform(-4, 4)), std::exp2(random.uniform(-4, 4)));
                const vec3 place = random.in_cube(i % 3 ? 1.0f : 1000.0f) * (i % 4 ? 100.0f : 1.0f);
                const AffineMap turned = then(rotation(random.uniform(0, 360), random.direction()), scaling(factors / double(size)));
                ASSERT_FALSE(add_instance(scene, make_group(scene),
                                          then(turned, then(rotation(random.uniform(0, 360), random.direction()), translation(place)))));
            }
        }
        TracedScene traced(scene, "wide_bvh");
        std::vector<Ray> rays;
        for (const PlacedGroup &instance : scene.instances)
            for (uint i = 0; i < 100; ++i) {
                const vec3 middle = 0.5f * (instance.bounds.low + instance.bounds.high), half = instance.bounds.high - middle;
                const vec3 at = middle + 0.7f * half * random.in_cube(1), origin = middle + 3 * glm::length(half) * random.direction();
                rays.push_back(make_ray(origin, vec3(glm::normalize(glm::dvec3(at) - glm::dvec3(origin)))));
            }
        const std::vector<Hit> hits = traced.closest_hits(rays);
        const std::vector<uint> instances = traced.instances();
        const std::vector<Surface> surfaces = traced.surfaces(rays, hits, instances);
        std::vector<Ray> leaving(rays.size(), make_ray({0, 0, 0}, {0, 0, 1}, -1));
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (hits[i].primitive == NO_HIT) continue;
            const vec3 direction = random.direction();
            const float side = glm::dot(direction, surfaces[i].geometric) < 0 ? -1.0f : 1.0f;
            leaving[i] = make_ray(moved_off(surfaces[i], 1), side * direction);
        }
        const std::vector<Hit> again = traced.closest_hits(leaving);
        uint left = 0, met = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (hits[i].primitive == NO_HIT) continue;
            ++left;
            met += again[i].primitive == hits[i].primitive && traced.instances()[i] == instances[i];
        }
        EXPECT_GT(left, 3000u);
        EXPECT_EQ(met, 0u) << "of " << left << " at size " << size;
    }
}

}  // namespace
}  // namespace brandung
