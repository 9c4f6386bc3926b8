/// The host's opinion of a crossing, in extended precision (64 bits of mantissa against the kernels' 24), with a bound on what rounding may do to it.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/core/items.h"
#include "tests/kernels/primitives/crossing_probe.h"

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

/// Where a ray may cross: t to within `error`; `sure` means that no rounding can make the kernel overlook it.
struct Root {
    real t, error;
    bool sure;
};

/// Whether a kernel's result is one that rounding can explain, given all roots: nothing sure is overlooked, nothing is made up.
inline testing::AssertionResult explains(const std::vector<Root> &roots, const CrossingResult &result, float t_max) {
    const auto surely_within = [&](const Root &root) { return root.sure && root.t > root.error && root.t + root.error < t_max; };
    if (!result.hit) {
        for (const Root &root : roots)
            if (surely_within(root)) return testing::AssertionFailure() << "overlooked t = " << root.t << " +- " << root.error;
        return testing::AssertionSuccess();
    }
    if (!(result.t > 0 && result.t <= t_max)) return testing::AssertionFailure() << "t = " << result.t << " is not in (0, " << t_max << "]";
    bool known = false;
    real nearest_known_error = 0;
    for (const Root &root : roots)
        if (std::abs(result.t - root.t) <= root.error) known = true, nearest_known_error = std::max(nearest_known_error, root.error);
    if (!known) {
        auto message = testing::AssertionFailure() << "made up t = " << result.t << "; there are";
        for (const Root &root : roots) message << " " << root.t << " +- " << root.error << (root.sure ? "" : "?");
        return message;
    }
    for (const Root &root : roots)
        if (surely_within(root) && root.t + root.error < result.t)
            return testing::AssertionFailure() << "overlooked t = " << root.t << " +- " << root.error << " before " << result.t;
    return testing::AssertionSuccess();
}

/// How many of the cases test something: a sure root within the ray.
inline std::size_t sure_hits(const std::vector<Root> &roots, float t_max) {
    for (const Root &root : roots)
        if (root.sure && root.t > root.error && root.t + root.error < t_max) return 1;
    return 0;
}

}  // namespace
}  // namespace brandung
