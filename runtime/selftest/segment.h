/// Distances from segments, and from the edges of triangles as a ray sees them.
#pragma once
#include "runtime/selftest/extended.h"

namespace brandung {

inline glm::dvec3 in_double(Vector v) { return {double(v.x), double(v.y), double(v.z)}; }

/// Square of the distance from the origin to the segment from p to q, in double: right to 2^-50 of the larger one's square.
inline double square_to_segment(Vector from, Vector to) {
    const glm::dvec3 p = in_double(from), along = in_double(to - from);
    const double square = glm::dot(along, along), s = square > 0 ? glm::clamp(-glm::dot(p, along) / square, 0.0, 1.0) : 0;
    const glm::dvec3 nearest = p + along * s;
    return glm::dot(nearest, nearest);
}

/// The part of w that lies across d.
inline Vector part_across(Vector w, Vector d) { return w - d * (dot(w, d) / dot(d, d)); }

/// So far may rounding move a vertex, as the ray sees it, over its largest coordinate M from the ray's origin: a sheared coordinate is off by 6 u M
/// (two differences, |shear| <= 1 and its product), so the ray passes a vertex at a distance that is off by 9 u M at most. A hundredth more is for
/// the rounding of squares, which are about 2^-42 M^2 and computed to 2^-50 M^2.
inline constexpr double doubtful_of_vertices = 9.1 * unit_roundoff;

}  // namespace brandung
