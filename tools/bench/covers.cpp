#include "tools/bench/covers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace brandung {
namespace {

using glm::dvec3;

/// From one corner to the next, counterclockwise as the ray sees it.
struct Edge {
    dvec3 from, to;
    std::size_t triangle;
    bool is_shared = false;  ///< another triangle has it the other way round
};

/// Triangles that the ray may pass at an edge, in sets that share edges.
class Patches {
public:
    Patches(const RayInSpace &ray, const SceneGeometry &geometry, const std::vector<Crossing> &crossings) {
        for (const Crossing &crossing : crossings) {
            const GeometryPrimitive &primitive = geometry.primitives[crossing.primitive];
            if (primitive.kind == GeometryPrimitive::Kind::triangle && !crossing.certain) add(crossing, seen_corners(ray, primitive));
        }
        share_edges();
    }

    std::vector<double> covering() const {
        std::vector<double> all;
        for (std::size_t patch = 0; patch < triangles_.size(); ++patch)
            if (patch_of_[patch] == patch && covers(patch)) all.push_back(last(patch));
        return all;
    }

private:
    void add(const Crossing &crossing, const std::array<dvec3, 3> &corners) {
        const auto [a, b, c] = corners;
        const double area = turn(a, b) + turn(b, c) + turn(c, a);
        if (area == 0) return;  // has no inside
        const std::size_t i = triangles_.size();
        for (const auto &[from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
            edges_.push_back(area > 0 ? Edge{from, to, i} : Edge{to, from, i});
        triangles_.push_back(crossing), patch_of_.push_back(i);
    }

    /// Seen corners of the same vertex have the same bits.
    void share_edges() {
        for (Edge &edge : edges_)
            for (Edge &other : edges_) {
                if (edge.is_shared || other.is_shared || edge.from != other.to || edge.to != other.from) continue;
                edge.is_shared = other.is_shared = true;
                const std::size_t kept = patch_of_[edge.triangle], joined = patch_of_[other.triangle];
                std::ranges::replace(patch_of_, std::max(kept, joined), std::min(kept, joined));
            }
    }

    bool covers(std::size_t patch) const {
        double slip = 0, winding = 0, nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            if (patch_of_[i] != patch) continue;
            if (!triangles_[i].within) return false;
            slip = std::max(slip, triangles_[i].slip);
        }
        for (const Edge &edge : edges_) {
            if (edge.is_shared || patch_of_[edge.triangle] != patch) continue;
            nearest = std::min(nearest, distance_from_edge(edge.from, edge.to));
            winding += std::atan2(turn(edge.from, edge.to), glm::dot(glm::dvec2(edge.from), glm::dvec2(edge.to)));
        }
        return nearest > slip && std::abs(winding) > 1;  // else 0: it is a multiple of a full turn
    }

    double last(std::size_t patch) const {
        double all = 0;
        for (std::size_t i = 0; i < triangles_.size(); ++i)
            if (patch_of_[i] == patch) all = std::max(all, triangles_[i].last);
        return all;
    }

    std::vector<Crossing> triangles_;
    std::vector<std::size_t> patch_of_;  ///< by triangle: the number of its set's first one
    std::vector<Edge> edges_;
};

}  // namespace

std::vector<double> covers(const RayInSpace &ray, const SceneGeometry &geometry, const std::vector<Crossing> &crossings) {
    return Patches(ray, geometry, crossings).covering();
}

}  // namespace brandung
