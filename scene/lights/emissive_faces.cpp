#include "scene/lights/emissive_faces.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "scene/vectors.h"

namespace brandung {
namespace {

using Triangle = std::array<uint, 3>;
/// Vertices of an edge, the lower first -> triangles that have it.
using Edges = std::map<std::pair<uint, uint>, std::vector<uint>>;

constexpr uint nobody = 0xffffffffu;

/// A face at a corner, with the sides that lead from it to two others. The points that kernels make of it have a rounding error of 2^-22 of these
/// lengths, and the fourth corner of a parallelogram may be off by as much as is_parallelogram allows.
EmissiveFace face_at(vec3 corner, vec3 a, vec3 b, bool is_triangle) {
    const vec3 u = a - corner, v = b - corner;
    const glm::dvec3 normal = glm::cross(glm::dvec3(a) - glm::dvec3(corner), glm::dvec3(b) - glm::dvec3(corner));
    return {.corner = corner,
            .u = u,
            .v = v,
            .normal = vec3(glm::normalize(normal)),
            .folded = is_triangle ? 1.0f : 0.0f,
            .error = 0x1p-20f * largest(glm::abs(corner) + glm::abs(u) + glm::abs(v)),
            .kept = 1,
            .alias = 0,
            .first = 0,
            .last = 0xffffffffu};
}

/// Whether the far corner is where the sides a and b from the corner lead together, to a few roundings.
bool is_parallelogram(vec3 corner, vec3 a, vec3 b, vec3 far) {
    const glm::dvec3 off = glm::abs(glm::dvec3(far) - (glm::dvec3(a) + glm::dvec3(b) - glm::dvec3(corner)));
    return std::max({off.x, off.y, off.z}) <= 0x1p-22 * double(largest(glm::abs(corner) + glm::abs(a) + glm::abs(b)));
}

class Pairing {
public:
    Pairing(const std::vector<vec3> &positions, std::span<const uint> indices) : positions_(positions) {
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) triangles_.push_back({indices[i], indices[i + 1], indices[i + 2]});
        for (uint t = 0; t < triangles_.size(); ++t)
            for (uint k = 0; k < 3; ++k) edges_[edge(t, k)].push_back(t);
        taken_.resize(triangles_.size());
    }

    std::vector<EmissiveFace> faces() {
        std::vector<EmissiveFace> faces;
        for (uint t = 0; t < triangles_.size(); ++t)
            if (!taken_[t]) faces.push_back(face_of(t));
        return faces;
    }

private:
    /// The edge opposite to corner k.
    std::pair<uint, uint> edge(uint t, uint k) const { return std::minmax(triangles_[t][(k + 1) % 3], triangles_[t][(k + 2) % 3]); }
    vec3 corner(uint t, uint k) const { return positions_[triangles_[t][k]]; }

    /// The corner that is not on the edge, if t goes along it this way.
    std::optional<vec3> opposite(uint t, uint from, uint to) const {
        for (uint k = 0; k < 3; ++k)
            if (triangles_[t][(k + 1) % 3] == from && triangles_[t][(k + 2) % 3] == to) return corner(t, k);
        return {};
    }

    /// The first free triangle that makes a parallelogram with t across the edge opposite to its corner k, and has its front on the same side.
    uint partner(uint t, uint k) const {
        const uint from = triangles_[t][(k + 1) % 3], to = triangles_[t][(k + 2) % 3];
        for (const uint other : edges_.at(edge(t, k))) {
            if (other == t || taken_[other]) continue;
            const std::optional<vec3> far = opposite(other, to, from);
            if (far && is_parallelogram(corner(t, k), positions_[from], positions_[to], *far)) return other;
        }
        return nobody;
    }

    EmissiveFace face_of(uint t) {
        uint best = nobody, at = 0;
        for (uint k = 0; k < 3; ++k)
            if (const uint other = partner(t, k); other < best) best = other, at = k;
        taken_[t] = true;
        if (best != nobody) taken_[best] = true;
        return face_at(corner(t, at), corner(t, (at + 1) % 3), corner(t, (at + 2) % 3), best == nobody);
    }

    const std::vector<vec3> &positions_;
    std::vector<Triangle> triangles_;
    Edges edges_;
    std::vector<bool> taken_;
};

}  // namespace

double area_of(const EmissiveFace &face) { return glm::length(glm::cross(glm::dvec3(face.u), glm::dvec3(face.v))) * (face.folded > 0 ? 0.5 : 1); }

std::vector<EmissiveFace> make_emissive_faces(const std::vector<vec3> &positions, std::span<const uint> indices) {
    return Pairing(positions, indices).faces();
}

}  // namespace brandung
