#include "scene/meshes/mesh_builder.h"

#include <algorithm>
#include <cmath>

#include "scene/primitives/add.h"
#include "scene/vectors.h"

namespace brandung {
namespace {

bool has_colors(const std::vector<MeshVertex> &corners) {
    return std::all_of(corners.begin(), corners.end(), [](const MeshVertex &v) { return v.color != MeshVertex::none; });
}

/// Of unit length; 0 without area.
glm::dvec3 face_normal(std::span<const vec3> polygon) {
    const glm::dvec3 area = area_vector(polygon);
    const double length = glm::length(area);
    return length > 0 ? area / length : glm::dvec3(0);
}

/// The angle at a corner [radians].
double angle_at(vec3 previous, vec3 corner, vec3 next) {
    const glm::dvec3 a = glm::dvec3(previous) - glm::dvec3(corner), b = glm::dvec3(next) - glm::dvec3(corner);
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

void MeshTables::add_normal(vec3 normal) {
    const glm::dvec3 n(normal);
    const double length = glm::length(n);
    normals.push_back(is_finite(normal) && length > 0 ? vec3(n / length) : vec3(0));
}

void MeshBuilder::set_material(uint material) {
    if (material != material_) start_part();
    material_ = material;
}

MeshBuilder::Normals MeshBuilder::normals_of(const std::vector<MeshVertex> &corners, std::map<std::string, uint> &warnings) const {
    const bool given = std::all_of(corners.begin(), corners.end(), [](const MeshVertex &v) { return v.normal != MeshVertex::none; });
    if (given) {
        const bool usable = std::all_of(corners.begin(), corners.end(), [&](const MeshVertex &v) { return tables_.normals[v.normal] != vec3(0); });
        if (usable) return Normals::own;
        ++warnings["face with a normal that has no direction: without"];
    }
    return smoothing_ != 0 ? Normals::smoothed : Normals::none;
}

bool MeshBuilder::has_uvs(const std::vector<MeshVertex> &corners) const {
    return std::all_of(corners.begin(), corners.end(), [&](const MeshVertex &v) {
        return v.uv != MeshVertex::none && std::isfinite(tables_.uvs[v.uv].x) && std::isfinite(tables_.uvs[v.uv].y);
    });
}

/// Goes on with the last part, or begins one if the face does not fit into it.
void MeshBuilder::open_part(Normals normals, bool uvs, bool colors) {
    if (part_is_open_ && normals == normals_ && uvs == uvs_ && colors == colors_) return;
    locals_.clear(), local_places_.clear();
    parts_.push_back({material_, {}});
    if (normals == Normals::smoothed) smooth_parts_.push_back({parts_.size() - 1, {}});
    part_is_open_ = true, normals_ = normals, uvs_ = uvs, colors_ = colors;
}

/// The number of a vertex in the last part.
uint MeshBuilder::local(const MeshVertex &vertex) {
    const uint hash = hash_of(vertex.position, vertex.uv, vertex.normal, vertex.color);
    const uint number = local_places_.find_or_add(hash, uint(locals_.size()), [&](uint place) { return locals_[place] == vertex; });
    if (number < locals_.size()) return number;
    locals_.push_back(vertex);
    MeshData &mesh = parts_.back().mesh;
    mesh.positions.push_back(tables_.positions[vertex.position]);
    if (colors_) mesh.colors.push_back(tables_.colors[vertex.color]);
    if (uvs_) mesh.uvs.push_back(tables_.uvs[vertex.uv]);
    if (normals_ == Normals::own) mesh.normals.push_back(tables_.normals[vertex.normal]);
    if (normals_ == Normals::smoothed) smooth_parts_.back().normals.push_back(vertex.normal);
    return number;
}

/// The place of the smoothing group's normal at a position.
uint MeshBuilder::smooth_normal(uint position) {
    const auto is_at = [&](uint place) { return smooth_normals_[place].position == position && smooth_normals_[place].group == smoothing_; };
    const uint place = smooth_places_.find_or_add(hash_of(position, smoothing_), uint(smooth_normals_.size()), is_at);
    if (place == smooth_normals_.size()) smooth_normals_.push_back({glm::dvec3(0), position, smoothing_});
    return place;
}

/// Weighs the face's normal by the angle at each corner, which makes the sum independent of how faces are divided (Thürmer and Wüthrich 1998).
void MeshBuilder::smooth(std::vector<MeshVertex> &corners) {
    const glm::dvec3 normal = face_normal(polygon_);
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        corners[i].normal = smooth_normal(corners[i].position);
        smooth_normals_[corners[i].normal].sum += normal * angle_at(polygon_[(i + n - 1) % n], polygon_[i], polygon_[(i + 1) % n]);
    }
}

void MeshBuilder::add_face(const std::vector<MeshVertex> &corners, std::map<std::string, uint> &warnings) {
    if (corners.size() < 3) {
        ++warnings["face with fewer than 3 corners: left out"];
        return;
    }
    polygon_.clear();
    for (const MeshVertex &corner : corners) polygon_.push_back(tables_.positions[corner.position]);
    if (!std::all_of(polygon_.begin(), polygon_.end(), is_finite)) {
        ++warnings["face with a vertex that is no number or beyond 1e15: left out"];
        return;
    }
    const Normals normals = normals_of(corners, warnings);
    const bool uvs = has_uvs(corners), colors = has_colors(corners);
    open_part(normals, uvs, colors);
    corners_ = corners;
    for (MeshVertex &corner : corners_) {  // what is not used does not tell vertices apart
        if (!uvs) corner.uv = MeshVertex::none;
        if (!colors) corner.color = MeshVertex::none;
        if (normals == Normals::none) corner.normal = MeshVertex::none;
    }
    if (normals == Normals::smoothed) smooth(corners_);
    vertices_.clear();
    for (const MeshVertex &corner : corners_) vertices_.push_back(local(corner));
    MeshData &mesh = parts_.back().mesh;
    if (vertices_.size() == 3)
        mesh.indices.insert(mesh.indices.end(), vertices_.begin(), vertices_.end());
    else
        for (const uint corner : triangulate_polygon(polygon_, warnings)) mesh.indices.push_back(vertices_[corner]);
    if (number_) mesh.numbers.resize(mesh.indices.size() / 3, *number_);
}

/// Where a sum has no direction, a triangle's own normal takes its place.
void MeshBuilder::fill_normals(const SmoothPart &smooth) {
    MeshData &mesh = parts_[smooth.part].mesh;
    mesh.normals.assign(mesh.positions.size(), vec3(0));
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const glm::dvec3 sum = smooth_normals_[smooth.normals[i]].sum;
        if (glm::length(sum) > 1e-6) mesh.normals[i] = vec3(glm::normalize(sum));
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const vec3 triangle[] = {mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]], mesh.positions[mesh.indices[i + 2]]};
        for (int k = 0; k < 3; ++k) {
            vec3 &normal = mesh.normals[mesh.indices[i + k]];
            if (normal == vec3(0)) normal = vec3(face_normal(triangle));
        }
    }
}

std::vector<MeshPart> MeshBuilder::finish() {
    for (const SmoothPart &smooth : smooth_parts_) fill_normals(smooth);
    std::erase_if(parts_, [](const MeshPart &part) { return part.mesh.indices.empty(); });
    return std::move(parts_);
}

}  // namespace brandung
