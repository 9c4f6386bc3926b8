#include "runtime/selftest/closed_meshes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace brandung {
namespace {

/// Octahedron, its faces split in four `levels` times; then affine.
ClosedMesh ball(const char *name, uint levels, vec3 scale, vec3 center, float radius) {
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
    return {name, MeshData{.positions = p, .indices = faces}, true, {center}, radius};
}

/// A drum with `sides` sides whose lids are fans from one rim vertex: slivers.
ClosedMesh drum(const char *name, uint sides) {
    MeshData mesh;
    for (uint i = 0; i < sides; ++i)
        for (const float z : {-1.0f, 1.0f}) {
            const double angle = 2 * std::numbers::pi * i / sides;
            mesh.positions.push_back({float(std::cos(angle)), float(std::sin(angle)), z});
        }
    for (uint i = 0; i < sides; ++i) {
        const uint a = 2 * i, b = 2 * ((i + 1) % sides);
        mesh.indices.insert(mesh.indices.end(), {a, b, a + 1, b, b + 1, a + 1});
        if (i > 0 && i + 1 < sides) mesh.indices.insert(mesh.indices.end(), {0, b, a, 1, a + 1, b + 1});
    }
    return {name, mesh, true, {vec3(0)}, 0.5f};
}

/// A ball with a vertex on every face's first edge, moved into the face by `width` of the edge's length: what is left at the edge is a needle.
ClosedMesh needles(const char *name, float width) {
    ClosedMesh closed = ball(name, 3, vec3(1), vec3(0), 0.9f);
    std::vector<vec3> &p = closed.mesh.positions;
    std::vector<uint> faces;
    for (std::size_t i = 0; i < closed.mesh.indices.size(); i += 3) {
        const uint a = closed.mesh.indices[i], b = closed.mesh.indices[i + 1], c = closed.mesh.indices[i + 2], m = uint(p.size());
        const vec3 middle = 0.5f * (p[a] + p[b]);
        p.push_back(middle + width * (p[c] - middle));
        faces.insert(faces.end(), {a, m, c, m, b, c, a, b, m});
    }
    closed.mesh.indices = faces;
    closed.convex = false;  // but for rounding
    return closed;
}

/// A tube around the (2, 3) torus knot.
ClosedMesh torus_knot(const char *name, uint rings, uint sides, double radius) {
    const auto knot = [&](double part) {
        const double angle = 2 * std::numbers::pi * part, r = 2 + std::cos(3 * angle);
        return glm::dvec3(r * std::cos(2 * angle), r * std::sin(2 * angle), std::sin(3 * angle));
    };
    ClosedMesh closed{name, {}, false, {}, float(radius / 2)};
    for (uint i = 0; i < rings; ++i) {
        const glm::dvec3 center = knot(double(i) / rings), along = glm::normalize(knot((i + 0.5) / rings) - knot((i - 0.5) / rings));
        const glm::dvec3 x = glm::normalize(glm::cross(along, glm::dvec3(0, 0, 1))), y = glm::cross(along, x);
        closed.centers.push_back(vec3(center));
        for (uint j = 0; j < sides; ++j) {
            const double angle = 2 * std::numbers::pi * j / sides;
            closed.mesh.positions.push_back(vec3(center + radius * (std::cos(angle) * x + std::sin(angle) * y)));
            const uint next = (j + 1) % sides, below = i * sides, above = (i + 1) % rings * sides;
            closed.mesh.indices.insert(closed.mesh.indices.end(), {below + j, below + next, above + j, below + next, above + next, above + j});
        }
    }
    return closed;
}

}  // namespace

const std::vector<ClosedMesh> &closed_meshes() {
    static const std::vector<ClosedMesh> meshes = {ball("ball", 4, vec3(1), vec3(0), 0.9f),
                                                   ball("small", 4, vec3(1e-3f), vec3(100, -50, 30), 0.9e-3f),
                                                   ball("flat", 4, vec3(1, 1, 0.01f), vec3(0), 0.009f),
                                                   ball("fine", 7, vec3(1), vec3(0), 0.9f),
                                                   drum("drum", 32),
                                                   drum("drum_of_slivers", 2048),
                                                   needles("needles", 0x1p-20f),
                                                   torus_knot("torus_knot", 512, 24, 0.3)};
    return meshes;
}

Ray ray_from_within(InputSource &source, const ClosedMesh &closed) {
    const auto &[positions, normals, uvs, colors, indices, numbers] = closed.mesh;
    const vec3 center = closed.centers[source.below(uint(closed.centers.size()))];
    const vec3 origin = center + source.in_cube(0.57f) * closed.radius;
    const std::size_t face = source.below(uint(indices.size() / 3)) * 3;
    const vec3 a = positions[indices[face]], b = positions[indices[face + 1]], c = positions[indices[face + 2]];
    const float s = source.uniform(0, 1), t = source.uniform(0, 1 - s);
    const vec3 targets[] = {a, a + (b - a) * s, a + (b - a) * s + (c - a) * t}, target = targets[source.below(3)];
    const vec3 direction = source.one_in(2) ? target - origin : vec3(glm::normalize(glm::dvec3(target) - glm::dvec3(origin)));
    return {.origin = origin, .t_max = std::numeric_limits<float>::infinity(), .direction = direction, .tag = RAY_TAG(RAY_CAMERA, NO_HIT)};
}

}  // namespace brandung
