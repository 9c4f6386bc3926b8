/// Closed meshes of triangles are watertight.
#include <gtest/gtest.h>

#include <map>

#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {
namespace {

/// A closed mesh and points inside it.
struct Closed {
    const char *name;
    MeshData mesh;
    vec3 center;
    float radius;  ///< of a ball inside, about the center
};
void PrintTo(const Closed &closed, std::ostream *out) { *out << closed.name; }

/// Octahedron, its faces split in four `levels` times; then affine.
Closed ball(const char *name, uint levels, vec3 scale, vec3 center, float radius) {
    std::vector<vec3> p = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<uint> faces = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    for (uint level = 0; level < levels; ++level) {
        std::map<std::pair<uint, uint>, uint> middles;
        const auto middle = [&](uint a, uint b) {
            const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b), uint(p.size()));
            if (is_new) p.push_back(glm::normalize(p[a] + p[b]));
            return entry->second;
        };
        std::vector<uint> finer;
        for (std::size_t i = 0; i < faces.size(); i += 3) {
            const uint a = faces[i], b = faces[i + 1], c = faces[i + 2], ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
        }
        faces = finer;
    }
    for (vec3 &v : p) v = center + v * scale;
    return {name, MeshData{.positions = p, .indices = faces}, center, radius};
}

/// A drum with `sides` sides whose lids are fans from one rim vertex: slivers.
Closed drum(const char *name, uint sides) {
    MeshData mesh;
    for (uint i = 0; i < sides; ++i)
        for (const float z : {-1.0f, 1.0f}) {
            const double angle = 2 * 3.14159265358979 * i / sides;
            mesh.positions.push_back({float(std::cos(angle)), float(std::sin(angle)), z});
        }
    for (uint i = 0; i < sides; ++i) {
        const uint a = 2 * i, b = 2 * ((i + 1) % sides);
        mesh.indices.insert(mesh.indices.end(), {a, b, a + 1, b, b + 1, a + 1});
        if (i > 0 && i + 1 < sides) mesh.indices.insert(mesh.indices.end(), {0, b, a, 1, a + 1, b + 1});
    }
    return {name, mesh, vec3(0), 0.5f};
}

/// A ball with a vertex on every face's first edge, moved into the face by `width` of the edge's length: what is left at the edge is a needle.
Closed needles(const char *name, float width) {
    Closed closed = ball(name, 3, vec3(1), vec3(0), 0.9f);
    std::vector<vec3> &p = closed.mesh.positions;
    std::vector<uint> faces;
    for (std::size_t i = 0; i < closed.mesh.indices.size(); i += 3) {
        const uint a = closed.mesh.indices[i], b = closed.mesh.indices[i + 1], c = closed.mesh.indices[i + 2], m = uint(p.size());
        const vec3 middle = 0.5f * (p[a] + p[b]);
        p.push_back(middle + width * (p[c] - middle));
        faces.insert(faces.end(), {a, m, c, m, b, c, a, b, m});
    }
    closed.mesh.indices = faces;
    return closed;
}

class Watertight : public testing::TestWithParam<Closed> {};

TEST_P(Watertight, EveryRayFromInsideMeetsAClosedMesh) {
    const Closed &closed = GetParam();
    Scene scene;
    add_material(scene, matte(1));
    add_triangle_mesh(scene, 0, closed.mesh);
    EXPECT_TRUE(scene.warnings.empty());
    TracedScene traced(scene, "wide_bvh");
    Random random(1);
    std::vector<Ray> rays;
    const std::vector<uint> &indices = closed.mesh.indices;
    while (rays.size() < 250'000) {
        const vec3 origin = closed.center + random.in_cube(0.57f) * closed.radius;
        const std::size_t triangle = random.below(uint(indices.size() / 3)) * 3;
        const vec3 a = closed.mesh.positions[indices[triangle]], b = closed.mesh.positions[indices[triangle + 1]];
        const vec3 c = closed.mesh.positions[indices[triangle + 2]];
        const float s = random.uniform(0, 1), t = random.uniform(0, 1 - s);
        const vec3 targets[3] = {a, a + (b - a) * s, a + (b - a) * s + (c - a) * t};
        const vec3 target = targets[random.below(3)];
        const vec3 direction = random.below(2) ? target - origin : vec3(glm::normalize(glm::dvec3(target) - glm::dvec3(origin)));
        rays.push_back(make_ray(origin, direction));
    }
    std::size_t lost = 0;
    const std::vector<Hit> hits = traced.closest_hits(rays);
    for (std::size_t i = 0; i < hits.size(); ++i)
        if (hits[i].primitive == NO_HIT && ++lost <= 2)
            ADD_FAILURE() << std::hexfloat << "lost: origin " << rays[i].origin.x << ' ' << rays[i].origin.y << ' ' << rays[i].origin.z
                          << ", direction " << rays[i].direction.x << ' ' << rays[i].direction.y << ' ' << rays[i].direction.z;
    EXPECT_EQ(lost, 0u) << "of " << rays.size();
}

INSTANTIATE_TEST_SUITE_P(Meshes, Watertight,
                         testing::Values(ball("ball", 4, vec3(1), vec3(0), 0.9f), ball("small", 4, vec3(1e-3f), vec3(100, -50, 30), 0.9e-3f),
                                         ball("flat", 4, vec3(1, 1, 0.01f), vec3(0), 0.009f), ball("fine", 7, vec3(1), vec3(0), 0.9f),
                                         drum("drum", 32), drum("drum_of_slivers", 2048), needles("needles", 0x1p-20f)),
                         [](const auto &info) { return info.param.name; });

}  // namespace
}  // namespace brandung
