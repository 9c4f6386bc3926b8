/// Vectors of long double: 64 bits of mantissa against the kernels' 24.
#pragma once
#include <cmath>

#include "kernels/core/portable.h"

namespace brandung {
namespace {  // of the same names as the self-test's

using real = long double;

/// Half an ulp of 1 in float: the relative error of one operation.
constexpr real unit_roundoff = 0x1p-24L;

struct Vector {
    real x, y, z;
    Vector(real x, real y, real z) : x(x), y(y), z(z) {}
    Vector(vec3 v) : x(v.x), y(v.y), z(v.z) {}
    Vector operator+(Vector b) const { return {x + b.x, y + b.y, z + b.z}; }
    Vector operator-(Vector b) const { return {x - b.x, y - b.y, z - b.z}; }
    Vector operator*(real s) const { return {x * s, y * s, z * s}; }
};
inline real dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(Vector a, Vector b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline real length(Vector a) { return std::sqrt(dot(a, a)); }
inline Vector unit(Vector a) { return a * (1 / length(a)); }

}  // namespace
}  // namespace brandung
