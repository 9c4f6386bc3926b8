/// Polygons: made into triangles when they are read.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/parameters.h"
#include "scene/primitives/add.h"
#include "scene/primitives/kinds.h"
#include "scene/vectors.h"

namespace brandung {
namespace {

/// Where vertices are nearly collinear, a polygon in order has triangles that floats cannot tell from lines: nothing is lost without them.
std::vector<uint> triangles_with_area(const std::vector<vec3> &vertices) {
    const std::vector<uint> all = triangulate(vertices);
    std::vector<uint> triangles;
    for (std::size_t i = 0; i < all.size(); i += 3) {
        if (has_area(vertices[all[i]], vertices[all[i + 1]], vertices[all[i + 2]]))
            triangles.insert(triangles.end(), {all[i], all[i + 1], all[i + 2]});
    }
    return triangles;
}

/// By how much the corners may leave the mean plane, as a part of the polygon's size: more than measured rooms do (the Cornell box has 1e-3).
constexpr double flatness = 1e-2;

/// Whether the corners lie in one plane. Without area there is no plane to leave.
bool is_flat(const std::vector<vec3> &vertices) {
    const glm::dvec3 origin(vertices[0]);
    const glm::dvec3 area = area_vector(vertices);
    glm::dvec3 mean(0);
    double size = 0;
    for (const vec3 &vertex : vertices) {
        const glm::dvec3 corner = glm::dvec3(vertex) - origin;
        mean += corner / double(vertices.size());
        size = std::max(size, glm::length(corner));
    }
    if (glm::length(area) == 0) return true;
    const glm::dvec3 normal = glm::normalize(area);
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](const vec3 &vertex) { return std::abs(glm::dot(normal, glm::dvec3(vertex) - origin - mean)) <= flatness * size; });
}

}  // namespace

std::vector<uint> triangulate_polygon(const std::vector<vec3> &vertices, std::map<std::string, uint> &warnings) {
    std::vector<uint> triangles = triangles_with_area(vertices);
    if (triangles.empty())
        ++warnings["polygon without area: left out"];
    else if (!is_flat(vertices))
        ++warnings["polygon whose corners do not lie in one plane: its triangles are bent against each other"];
    return triangles;
}

void append_polygon(Scene &scene, MeshData &mesh, const std::vector<vec3> &vertices, const std::vector<vec3> &normals) {
    const std::vector<uint> triangles = triangulate_polygon(vertices, scene.warnings);
    if (triangles.empty()) return;
    const uint first = uint(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), vertices.begin(), vertices.end());
    mesh.normals.insert(mesh.normals.end(), normals.begin(), normals.end());
    for (const uint index : triangles) mesh.indices.push_back(first + index);
}

void read_polygon(const Parameters &parameters, uint material, Scene &scene) {
    parameters.expect("vertices");
    const std::vector<vec3> vertices = parameters.vectors("vertices");
    if (vertices.size() < 3) parameters.fail("vertices", fmt::format("must be at least 3 points, got {}", vertices.size()));
    const std::vector<vec2> uvs = read_uvs(parameters, vertices.size());
    MeshData mesh;
    append_polygon(scene, mesh, vertices, read_normals(parameters, "normals", vertices.size()));
    if (!mesh.positions.empty()) mesh.uvs = uvs;
    add_triangle_mesh(scene, material, std::move(mesh));
}

}  // namespace brandung
