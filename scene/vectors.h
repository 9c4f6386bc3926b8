/// Functions of vectors that glm lacks.
#pragma once
#include <algorithm>
#include <cmath>
#include <span>

#include "kernels/core/portable.h"

namespace brandung {

inline bool is_finite(vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// The largest of the three parts.
inline float largest(vec3 v) { return std::max({v.x, v.y, v.z}); }

/// Twice the vector area of a polygon of at least one corner (Newell): its direction is that of the normal.
inline glm::dvec3 area_vector(std::span<const vec3> polygon) {
    glm::dvec3 sum(0);
    const glm::dvec3 origin(polygon[0]);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) sum += glm::cross(glm::dvec3(polygon[i]) - origin, glm::dvec3(polygon[i + 1]) - origin);
    return sum;
}

}  // namespace brandung
