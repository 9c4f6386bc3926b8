/// Numbers and vectors of extended precision, in which the host says what is right.
#pragma once
#include <cmath>
#include <limits>

#include "kernels/core/portable.h"

namespace brandung {

/// 113 bits of mantissa against the kernels' 24, where the compiler has them; the operations are those of its own library.
#ifdef __SIZEOF_FLOAT128__
using extended = __float128;
#else
using extended = long double;
#endif

/// Half an ulp of 1 in float: the relative error of one operation.
inline constexpr double unit_roundoff = 0x1p-24;

inline extended absolute(extended x) { return x < 0 ? -x : x; }
inline extended greater(extended a, extended b) { return a > b ? a : b; }
inline extended lesser(extended a, extended b) { return a < b ? a : b; }
inline bool is_finite(extended x) { return x - x == 0; }
/// Newton's step doubles the digits of long double's root. Of numbers below 0 it is 0.
inline extended square_root(extended x) {
    if (!(x > 0)) return 0;
    const long double root = std::sqrt(static_cast<long double>(x));
    const extended y = root;
    return root > 0 && is_finite(y) ? y + (x - y * y) * (0.5L / root) : y;
}

struct Vector {
    extended x, y, z;
    Vector(extended x, extended y, extended z) : x(x), y(y), z(z) {}
    Vector(vec3 v) : x(v.x), y(v.y), z(v.z) {}
    Vector operator+(Vector b) const { return {x + b.x, y + b.y, z + b.z}; }
    Vector operator-(Vector b) const { return {x - b.x, y - b.y, z - b.z}; }
    Vector operator*(extended s) const { return {x * s, y * s, z * s}; }
};
inline extended dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(Vector a, Vector b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline extended length(Vector a) { return square_root(dot(a, a)); }
inline Vector unit(Vector a) { return a * (1 / length(a)); }
inline Vector magnitude(Vector a) { return {absolute(a.x), absolute(a.y), absolute(a.z)}; }
inline extended largest(Vector a) { return greater(absolute(a.x), greater(absolute(a.y), absolute(a.z))); }

/// The distance between neighbours among floats at |x| [ulp].
inline double ulp_of(extended x) {
    const double magnitude = std::abs(static_cast<double>(x));
    if (!(magnitude >= 0x1p-126)) return 0x1p-149;
    return std::ldexp(1.0, std::ilogb(std::fmin(magnitude, 0x1p127)) - 23);
}

}  // namespace brandung
