/// An affine map in extended precision, and its exact inverse.
#pragma once
#include "kernels/primitives/instance.h"
#include "runtime/selftest/extended.h"

namespace brandung {

/// p -> x p.x + y p.y + z p.z + origin.
struct ExtendedMap {
    Vector x, y, z, origin;
    explicit ExtendedMap(const Transform &m) : x(m.x), y(m.y), z(m.z), origin(m.origin) {}

    Vector direction(Vector d) const { return x * d.x + y * d.y + z * d.z; }
    Vector point(Vector p) const { return direction(p) + origin; }
    extended determinant() const { return dot(x, cross(y, z)); }
    Vector direction_back(Vector d) const { return Vector(dot(cross(y, z), d), dot(cross(z, x), d), dot(cross(x, y), d)) * (1 / determinant()); }
    Vector point_back(Vector p) const { return direction_back(p - origin); }
    /// By the inverse transposed, which keeps normals across their surfaces.
    Vector normal(Vector n) const { return (cross(y, z) * n.x + cross(z, x) * n.y + cross(x, y) * n.z) * (1 / determinant()); }
    /// By magnitudes: what errors of so much become at most.
    Vector direction_of_magnitudes(Vector d) const { return magnitude(x) * d.x + magnitude(y) * d.y + magnitude(z) * d.z; }
    Vector point_of_magnitudes(Vector p) const { return direction_of_magnitudes(p) + magnitude(origin); }
    Vector normal_of_magnitudes(Vector n) const { return {dot(magnitude(x), n), dot(magnitude(y), n), dot(magnitude(z), n)}; }
};

}  // namespace brandung
