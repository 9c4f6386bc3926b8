/// Polygons: made into triangles when they are read.
#include <fmt/format.h>

#include "scene/parameters.h"
#include "scene/primitives/add.h"
#include "scene/primitives/kinds.h"

namespace brandung {

void append_polygon(Scene &scene, MeshData &mesh, const std::vector<vec3> &vertices, const std::vector<vec3> &normals) {
    const std::vector<uint> triangles = triangulate(vertices);
    if (triangles.empty()) {
        ++scene.warnings["polygon without area: left out"];
        return;
    }
    const uint first = uint(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), vertices.begin(), vertices.end());
    mesh.normals.insert(mesh.normals.end(), normals.begin(), normals.end());
    for (const uint index : triangles) mesh.indices.push_back(first + index);
}

void read_polygon(const Parameters &parameters, uint material, Scene &scene) {
    const std::vector<vec3> vertices = parameters.vectors("vertices");
    if (vertices.size() < 3) parameters.fail("vertices", fmt::format("must be at least 3, got {}", vertices.size()));
    MeshData mesh;
    append_polygon(scene, mesh, vertices, read_normals(parameters, "normals", vertices.size()));
    add_triangle_mesh(scene, material, std::move(mesh));
}

}  // namespace brandung
