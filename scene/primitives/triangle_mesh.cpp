/// Meshes of triangles, flat or with interpolated normals.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>

#include "kernels/primitives/smooth_triangle.h"
#include "scene/lights/emissive_cells.h"
#include "scene/lights/emissive_faces.h"
#include "scene/lights/light.h"
#include "scene/parameters.h"
#include "scene/primitives/add.h"
#include "scene/primitives/kinds.h"

namespace brandung {

const PrimitiveKind triangle_kind = {"triangle", "Triangle", sizeof(TriangleBlock), true, true, 0};
const PrimitiveKind smooth_triangle_kind = {"smooth_triangle", "SmoothTriangle", sizeof(SmoothTriangleBlock), true, true, sizeof(VertexNormals)};

bool has_area(vec3 a, vec3 b, vec3 c) {
    const glm::dvec3 n = glm::abs(glm::cross(glm::dvec3(b - a), glm::dvec3(c - a)));
    return std::max({n.x, n.y, n.z}) >= double(std::numeric_limits<float>::min());
}

namespace {

class TriangleMesh final : public Shape {
public:
    TriangleMesh(uint material, MeshData mesh) : Shape(material), mesh_(std::move(mesh)) {}

    const PrimitiveKind &kind() const override { return mesh_.normals.empty() ? triangle_kind : smooth_triangle_kind; }
    std::size_t count() const override { return mesh_.indices.size() / 3; }

    Bounds bounds(std::size_t i) const override {
        Bounds bounds;
        for (uint k = 0; k < 3; ++k) bounds.add(position(i, k));
        return bounds;
    }

    Hull hull(std::size_t i) const override {
        Hull hull;
        for (uint k = 0; k < 3; ++k) hull.add({.center = position(i, k)});
        return hull;
    }

    void write_lane(std::size_t i, uint lane, std::byte *block) const override {
        TriangleBlock &triangles = *reinterpret_cast<TriangleBlock *>(block);
        for (int axis = 0; axis < 3; ++axis) {
            triangles.a[axis][lane] = position(i, 0)[axis];
            triangles.b[axis][lane] = position(i, 1)[axis];
            triangles.c[axis][lane] = position(i, 2)[axis];
        }
    }

    void write_shading(std::size_t i, uint *words, SharedTables &tables) const override {
        SmoothTriangleShading shading = {{position(i, 0), position(i, 1), position(i, 2), 0, 0}, 0};
        if (tables.wants_uvs && mesh_.uvs.empty()) ++tables.lack_uvs;
        if (tables.wants_uvs && !mesh_.uvs.empty()) {
            tables.vertex_uvs.push_back({uv(i, 0), uv(i, 1), uv(i, 2)});
            shading.flat.uvs = uint(tables.vertex_uvs.size());
        }
        if (!mesh_.colors.empty()) {
            tables.vertex_colors.push_back({color(i, 0), color(i, 1), color(i, 2)});
            shading.flat.colors = uint(tables.vertex_colors.size());
        }
        if (!mesh_.normals.empty()) {
            shading.normals = uint(tables.vertex_normals.size());
            tables.vertex_normals.push_back({normal(i, 0), normal(i, 1), normal(i, 2)});
        }
        std::memcpy(words, &shading, mesh_.normals.empty() ? sizeof(TriangleShading) : sizeof(SmoothTriangleShading));
    }

    std::vector<Light> light(uint cells, std::vector<EmissiveFace> &faces) const override {
        const EmissiveCells own = make_emissive_cells(make_emissive_faces(mesh_.positions, mesh_.indices), cells * cells);
        const Spectrum power(float(own.area / (cells * cells)));
        std::vector<Light> lights;
        for (uint cell = 0; cell < cells * cells; ++cell)
            lights.push_back(
                make_light(EmissiveMesh{{power, {}, 0, 0}, uint(faces.size()) + own.first[cell], own.first[cell + 1] - own.first[cell]}));
        faces.insert(faces.end(), own.faces.begin(), own.faces.end());
        return lights;
    }

    std::vector<Light> flat_lights() const override {
        std::vector<Light> lights;
        for (const EmissiveFace &face : make_emissive_faces(mesh_.positions, mesh_.indices))
            lights.push_back(make_light(EmissiveFlat{Spectrum(float(area_of(face))), uint(face.folded), face.corner, face.u, face.v, 0, 0}));
        return lights;
    }

private:
    const vec3 &position(std::size_t i, uint k) const { return mesh_.positions[mesh_.indices[3 * i + k]]; }
    const vec3 &normal(std::size_t i, uint k) const { return mesh_.normals[mesh_.indices[3 * i + k]]; }
    const vec2 &uv(std::size_t i, uint k) const { return mesh_.uvs[mesh_.indices[3 * i + k]]; }
    const Spectrum &color(std::size_t i, uint k) const { return mesh_.colors[mesh_.indices[3 * i + k]]; }

    MeshData mesh_;
};

void drop_flat_triangles(MeshData &mesh) {
    assert(mesh.indices.size() % 3 == 0);
    assert(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size());
    assert(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size());
    assert(mesh.colors.empty() || mesh.colors.size() == mesh.positions.size());
    assert(mesh.numbers.empty() || mesh.numbers.size() == mesh.indices.size() / 3);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const uint a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
        if (!has_area(mesh.positions[a], mesh.positions[b], mesh.positions[c])) continue;
        if (!mesh.numbers.empty()) mesh.numbers[kept / 3] = mesh.numbers[i / 3];
        for (const uint index : {a, b, c}) mesh.indices[kept++] = index;
    }
    mesh.indices.resize(kept);
    if (!mesh.numbers.empty()) mesh.numbers.resize(kept / 3);
}

}  // namespace

std::unique_ptr<Shape> make_triangle_mesh(uint material, MeshData mesh) {
    drop_flat_triangles(mesh);
    if (mesh.indices.empty()) return nullptr;
    return std::make_unique<TriangleMesh>(material, std::move(mesh));
}

void add_triangle_mesh(Scene &scene, uint material, MeshData mesh, const std::string &before) {
    const std::size_t triangles = mesh.indices.size() / 3;
    drop_flat_triangles(mesh);
    const std::size_t kept = mesh.indices.size() / 3;
    if (kept < triangles) scene.warnings["triangle without area: left out"] += uint(triangles - kept);
    if (kept == 0) return;
    std::vector<uint> numbers = std::exchange(mesh.numbers, {});
    scene.shapes.push_back(std::make_unique<TriangleMesh>(material, std::move(mesh)));
    if (scene.places && !numbers.empty()) scene.places->emplace(scene.shapes.back().get(), PlaceInFile{before, std::move(numbers)});
}

std::vector<vec3> read_normals(const Parameters &parameters, const std::string &name, std::size_t vertices) {
    std::vector<vec3> normals = parameters.vectors(name);
    if (!normals.empty() && normals.size() != vertices)
        parameters.fail(name, fmt::format("must be one per vertex, got {} for {} vertices", normals.size(), vertices));
    for (std::size_t i = 0; i < normals.size(); ++i) {
        if (normals[i] == vec3(0)) parameters.fail_element(name, i, "must not be zero");
        normals[i] = vec3(glm::normalize(glm::dvec3(normals[i])));
    }
    return normals;
}

std::vector<vec2> read_uvs(const Parameters &parameters, std::size_t vertices) {
    std::vector<vec2> uvs = parameters.pairs("uvs");
    if (!uvs.empty() && uvs.size() != vertices)
        parameters.fail("uvs", fmt::format("must be one pair per vertex, got {} for {} vertices", uvs.size(), vertices));
    return uvs;
}

void read_triangle_mesh(const Parameters &parameters, uint material, Scene &scene) {
    parameters.expect("positions");
    parameters.expect("indices");
    MeshData mesh;
    mesh.positions = parameters.vectors("positions");
    mesh.normals = read_normals(parameters, "normals", mesh.positions.size());
    mesh.uvs = read_uvs(parameters, mesh.positions.size());
    mesh.colors = parameters.vectors("colors");
    mesh.indices = parameters.integers("indices");
    if (mesh.positions.empty()) parameters.fail("positions", "must have vertices");
    if (!mesh.colors.empty() && mesh.colors.size() != mesh.positions.size())
        parameters.fail("colors", fmt::format("must be one per vertex, got {} for {} vertices", mesh.colors.size(), mesh.positions.size()));
    for (std::size_t i = 0; i < mesh.colors.size(); ++i)
        if (glm::any(glm::lessThan(mesh.colors[i], Spectrum(0)))) parameters.fail_element("colors", i, "must not be negative");
    if (mesh.indices.empty() || mesh.indices.size() % 3 != 0)
        parameters.fail("indices", fmt::format("must be three per triangle, got {}", mesh.indices.size()));
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (mesh.indices[i] >= mesh.positions.size())
            parameters.fail_element("indices", i,
                                    fmt::format("must be below the number of vertices, {}, got {}", mesh.positions.size(), mesh.indices[i]));
    }
    add_triangle_mesh(scene, material, std::move(mesh));
}

}  // namespace brandung
