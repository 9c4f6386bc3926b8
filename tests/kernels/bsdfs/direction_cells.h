/// Cells of the sphere of directions, for counts of samples.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "kernels/core/portable.h"

namespace brandung {

/// The unit square onto directions: by the angle from z, or, for facets of some roughness, by the normal h that mirrors wo into the direction:
/// as GGX of that roughness has them, and by azimuth.
class DirectionCells {
public:
    static constexpr std::size_t columns = 16, cells = columns * columns;

    DirectionCells(vec3 wo, double width) : wo_(wo), width_(width) {}

    struct Point {
        glm::dvec3 direction;
        double solid_angle;  ///< per unit of area of the square
    };
    Point at(double u, double v) const {
        if (width_ == 0) return {around_z(std::cos(M_PI * u), v), 2 * M_PI * M_PI * std::sin(M_PI * u)};
        const double slope2 = width_ * width_ * (1 / (u * u) - 1), z = 1 / std::sqrt(1 + slope2);
        const glm::dvec3 h = around_z(z, v);
        const double cosine = glm::dot(wo_, h);
        // dω of h is z³ d(tan²) / 2 dφ; that of what is mirrored is 4 |cosine| of it.
        return {2 * cosine * h - wo_, 4 * std::abs(cosine) * z * z * z * width_ * width_ / (u * u * u) * 2 * M_PI};
    }
    /// Of the cell that a direction lies in, if in any.
    std::optional<std::size_t> cell_of(glm::dvec3 direction) const {
        glm::dvec3 w = direction;
        double u = std::acos(std::clamp(w.z, -1.0, 1.0)) / M_PI;
        if (width_ > 0) {
            w = glm::normalize(direction + wo_);
            if (w.z <= 0) return {};
            u = 1 / std::sqrt(1 + (w.x * w.x + w.y * w.y) / (w.z * w.z) / (width_ * width_));
        }
        const double v = std::atan2(w.y, w.x) / (2 * M_PI);
        return index(u) * columns + index(v < 0 ? v + 1 : v);
    }

private:
    static std::size_t index(double x) { return std::min(static_cast<std::size_t>(x * columns), columns - 1); }
    static glm::dvec3 around_z(double z, double turns) {
        const double radius = std::sqrt(std::max(1 - z * z, 0.0));
        return {radius * std::cos(2 * M_PI * turns), radius * std::sin(2 * M_PI * turns), z};
    }

    glm::dvec3 wo_;
    double width_;
};

}  // namespace brandung
