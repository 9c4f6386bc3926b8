/// Frusta as tests make them, and the host's opinion of their crossings.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "kernels/primitives/frustum.h"
#include "tests/kernels/primitives/crossing_oracle.h"
#include "tests/kernels/primitives/crossing_probe.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {

extern const PrimitiveKind frustum_kind;

namespace {  // of the same names as the self-test's

inline constexpr float infinity = std::numeric_limits<float>::infinity();
/// Of random cases in a test.
inline constexpr std::size_t count = 100'000;

struct Frustum {
    vec3 base, apex;
    float base_radius, apex_radius;
};

inline std::unique_ptr<Shape> shape_of(const Frustum &f) { return make_frustum(0, f.base, f.base_radius, f.apex, f.apex_radius); }

inline CrossingProbe<FrustumBlock> probe_of(const std::vector<Frustum> &frusta) {
    std::vector<std::unique_ptr<Shape>> shapes;
    for (const Frustum &frustum : frusta) shapes.push_back(shape_of(frustum));
    return {frustum_kind, shapes};
}

inline const Frustum cone = {{0, 0, -1}, {0, 0, 1}, 1, 0};

/// What the block describes, as rounded: the surface that kernels are held to.
struct FrustumRecord {
    Vector center, axis;
    real half_length, radius, slope;
    bool inside_only;
    /// Distance from the axis' line to a point given from the centre, and the place along the axis, whose length is 1 only but for rounding.
    real place(Vector p) const { return dot(p, axis) / length(axis); }
    real across(Vector p) const { return length(cross(p, axis)) / length(axis); }
    real radius_at(real z) const { return radius + slope * z; }
    real size() const { return half_length + radius + std::abs(slope) * half_length; }
};
inline FrustumRecord record_of(const std::vector<FrustumBlock> &blocks, std::size_t i) {
    const FrustumBlock &b = blocks[i / BLOCK_SIZE];
    const std::size_t j = i % BLOCK_SIZE;
    return {Vector(b.center[0][j], b.center[1][j], b.center[2][j]),
            Vector(b.axis[0][j], b.axis[1][j], b.axis[2][j]),
            b.half_length[j],
            b.radius[j],
            b.slope[j],
            b.side[j] < 0};
}

/// Roots of |x|^2 = (r + s z)^2 by cross products from the point m of the ray that is nearest to the centre.
///
/// Rounding, with u = 2^-24, f = o - c, k = 1 + s^2: the kernel's m is off by e = 4 u |f| across the ray (f, the product and the sum), its z and x by
/// 4 u |m| more, and z by 2 u |z| since the axis has unit length only but for rounding. Its coefficients of F(t) = a t^2 + 2 b t + c are off by
/// da = 12 u k d^2, db = 12 u k d (m + r) + k d e, dc = 12 u (k m^2 + r^2) + 2 k (m + r) e, so F(t) by dF = da t^2 + 2 db |t| + dc, and a root by
/// dF / |F'(t)| as long as that is small against the distance to the other root, and by sqrt(2 dF / |a|) else.
/// The sum with the nearest point's t adds 4 u (|f| / d + |t|).
inline std::vector<Root> roots_of(const FrustumRecord &record, const Ray &ray) {
    const Vector d = ray.direction, f = Vector(ray.origin) - record.center, axis = unit(record.axis);
    const real u = unit_roundoff, dd = dot(d, d), d_length = std::sqrt(dd), nearest = -dot(f, d) / dd;
    const Vector m = f + d * nearest, dx = cross(d, axis), mx = cross(m, axis);
    const real dz = dot(d, axis), mz = dot(m, axis), s = record.slope, r = record.radius_at(mz), k = 1 + s * s;
    const real a = dot(dx, dx) - s * dz * s * dz, b = dot(mx, dx) - s * dz * r, c = dot(mx, mx) - r * r;
    const real e = 4 * u * length(f), size = length(m) + std::abs(r) + record.radius;
    const real da = 12 * u * k * dd, db = 12 * u * k * d_length * size + k * d_length * e, dc = 12 * u * k * size * size + 2 * k * size * e;
    const real discriminant = b * b - a * c, derror = 2 * std::abs(b) * db + db * db + std::abs(a) * dc + std::abs(c) * da + da * dc;
    if (discriminant < -derror) return {};

    const real root = std::sqrt(std::max(discriminant, 0.0L)), q = -(b + std::copysign(root, b));
    const real fz = dot(f, axis), fr = record.radius_at(fz), fx = length(cross(f, axis));
    const bool may_start_on = std::abs(fx * fx - fr * fr) <= 0x1p-19L * std::abs(fr) * (std::abs(fr) + std::abs(fz)) + 2 * dc;
    struct Candidate {
        real t, error;
        bool sure;
    } candidates[2];
    for (int i = 0; i < 2; ++i) {
        const real t = i == 0 ? q / a : c / q, df = da * t * t + 2 * db * std::abs(t) + dc;
        const bool apart = discriminant > derror && df * std::abs(a) < root * root / 4;
        const real error = apart ? df / root : 2 * std::sqrt((df + derror / std::abs(a)) / std::abs(a));
        candidates[i] = {nearest + t, error + 4 * u * (length(f) / d_length + std::abs(t)), apart};
    }
    std::vector<Root> roots;
    for (int i = 0; i < 2; ++i) {
        const auto [t, error, apart] = candidates[i];
        if (!std::isfinite(t)) continue;
        const real z = mz + (t - nearest) * dz, at_z = std::abs(dz) * error + 8 * u * (std::abs(z) + length(f));
        if (std::abs(z) > record.half_length + at_z) continue;
        const real radius = record.radius_at(z), at_radius = std::abs(s) * at_z + 4 * u * (record.radius + std::abs(s * z));
        if (radius < -at_radius) continue;
        const real gradient = a * (t - nearest) + b;
        if (record.inside_only && apart && gradient < 0) continue;
        const bool may_be_start = may_start_on && std::abs(t) <= std::abs(candidates[1 - i].t) + error;
        const bool sure = apart && !may_be_start && std::abs(z) < record.half_length - at_z && radius > at_radius;
        roots.push_back({t, error, sure});
    }
    return roots;
}

/// A cone, a cylinder or a frustum, of some only the inside; its ends are up to 8 sizes apart, its base up to 2^offset_bits sizes from the origin.
inline Frustum random_frustum(Random &random, float size, int offset_bits) {
    const vec3 base = random.direction() * (size * std::exp2(random.uniform(-2, float(offset_bits))));
    for (;;) {
        const vec3 apex = base + random.direction() * size * std::exp2(random.uniform(-3, 3));
        const float base_radius = size * random.uniform(0.1f, 1);
        const uint shape = random.below(4);
        const float apex_radius = shape == 0 ? base_radius : shape == 1 ? 0.0f : size * random.uniform(0, 1);
        const float sign = random.below(5) == 0 ? -1.0f : 1.0f;
        const Frustum frustum{base, apex, sign * base_radius, sign * apex_radius};
        if (shape_of(frustum)) return frustum;
    }
}

}  // namespace
}  // namespace brandung
