/// What meshes are made of, one thing after another.
#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "scene/bounds.h"
#include "scene/meshes/mesh_file.h"

namespace brandung {

template <class Visit> void for_each_vertex(const std::vector<MeshPart> &parts, const Visit &visit) {
    for (const MeshPart &part : parts)
        for (const uint index : part.mesh.indices) visit(glm::dvec3(part.mesh.positions[index]));
}

/// visit() is given the three corners.
template <class Visit> void for_each_triangle(const MeshPart &part, const Visit &visit) {
    const auto &[positions, indices] = std::tie(part.mesh.positions, part.mesh.indices);
    for (std::size_t i = 0; i < indices.size(); i += 3)
        visit(std::array<vec3, 3>{positions[indices[i]], positions[indices[i + 1]], positions[indices[i + 2]]});
}

struct BoundingSphere {
    glm::dvec3 center;
    double radius;
};

/// Around the centre of the meshes' box.
inline BoundingSphere bounding_sphere(const std::vector<MeshPart> &parts) {
    Bounds bounds;
    for_each_vertex(parts, [&](const glm::dvec3 &p) { bounds.add(vec3(p)); });
    if (bounds.empty()) return {glm::dvec3(0), 1};
    BoundingSphere sphere{0.5 * (glm::dvec3(bounds.low) + glm::dvec3(bounds.high)), 0};
    for_each_vertex(parts, [&](const glm::dvec3 &p) { sphere.radius = std::max(sphere.radius, glm::length(p - sphere.center)); });
    return sphere;
}

}  // namespace brandung
