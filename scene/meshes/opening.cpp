#include "scene/meshes/opening.h"

#include <cmath>
#include <numbers>

#include "scene/meshes/mesh_parts.h"
#include "scene/vectors.h"

namespace brandung {
namespace {

using glm::dvec3;

constexpr double shell_share = 0.1;     ///< a shell is open if its vector area is at least this part of its area; a box without a side has 0.2
constexpr double wall_share = 0.7;      ///< of the half away from the opening that a shell covers; a room without ceiling covers 5/6
constexpr int probes = 100;             ///< directions in which walls are looked for
constexpr double nearly_straight = 20;  // [degrees]

/// The vector area as a part of the area: 0 for closed surfaces, 1 for a flat one.
dvec3 mean_normal(const std::vector<MeshPart> &parts) {
    dvec3 vector(0);
    double area = 0;
    for (const MeshPart &part : parts)
        for_each_triangle(part, [&](const auto &corners) {
            const dvec3 n = area_vector(corners);
            vector += n, area += glm::length(n);
        });
    return area > 0 ? vector / area : dvec3(0);
}

/// Whether a ray meets a triangle (Möller and Trumbore 1997).
bool meets(const dvec3 &from, const dvec3 &way, const dvec3 &a, const dvec3 &b, const dvec3 &c) {
    const dvec3 p = glm::cross(way, c - a), q = glm::cross(from - a, b - a);
    const double determinant = glm::dot(b - a, p), u = glm::dot(from - a, p) / determinant, v = glm::dot(way, q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && glm::dot(c - a, q) / determinant > 0;  // false of what is not finite
}

/// Directions that are spread evenly over the half of the sphere around `axis`: points of a spiral (Swinbank and Purser 2006).
std::vector<dvec3> half_sphere(const dvec3 &axis) {
    const dvec3 side = glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0))), other = glm::cross(axis, side);
    std::vector<dvec3> directions;
    for (int i = 0; i < probes; ++i) {
        const double height = (i + 0.5) / probes, radius = std::sqrt(1 - height * height), turn = 2 * std::numbers::pi * i / std::numbers::phi;
        directions.push_back(height * axis + radius * (std::cos(turn) * side + std::sin(turn) * other));
    }
    return directions;
}

/// Whether most of what is seen from the middle, away from the opening, is the meshes: a room has walls, a floor with things on it does not.
bool encloses(const std::vector<MeshPart> &parts, const dvec3 &middle, const dvec3 &opening) {
    std::vector<dvec3> free = half_sphere(-opening);
    const auto found = [&] { return double(free.size()) <= (1 - wall_share) * probes; };
    for (const MeshPart &part : parts)
        for_each_triangle(part, [&](const auto &corners) {
            if (found()) return;
            const dvec3 a(corners[0]), b(corners[1]), c(corners[2]);
            std::erase_if(free, [&](const dvec3 &way) { return meets(middle, way, a, b, c); });
        });
    return found();
}

}  // namespace

dvec3 opening(const std::vector<MeshPart> &parts, const dvec3 &middle, const dvec3 &up) {
    const dvec3 mean = mean_normal(parts), horizontal = mean - up * glm::dot(mean, up);
    if (glm::length(horizontal) < shell_share) return dvec3(0);
    const dvec3 direction = glm::normalize(horizontal);
    if (!encloses(parts, middle, direction)) return dvec3(0);
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 along(0);
        along[axis] = std::copysign(1.0, direction[axis]);
        if (std::abs(direction[axis]) > std::cos(glm::radians(nearly_straight)) && std::abs(glm::dot(along, up)) < 1e-6) return along;
    }
    return direction;
}

}  // namespace brandung
