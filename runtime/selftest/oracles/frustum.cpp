/// Frusta in extended precision: roots of |x|^2 = (r + s z)^2 by cross products.
#include "kernels/primitives/frustum.h"

#include <array>
#include <cmath>
#include <numbers>

#include "runtime/selftest/oracles/oracles.h"
#include "scene/primitives/kinds.h"

namespace brandung {
namespace {

/// What the block describes, as rounded: the surface that kernels are held to. Points are given from the centre; the axis' length is 1 only but
/// for rounding.
struct Frustum {
    Vector center, axis;
    extended half_length, radius, slope;
    bool inside_only;
    extended place(Vector p) const { return dot(p, unit_axis()); }
    extended across(Vector p) const { return length(cross(p, unit_axis())); }
    extended radius_at(extended z) const { return radius + slope * z; }
    Vector unit_axis() const { return unit(axis); }
};

Frustum frustum_of(Lane lane) {
    const FrustumBlock &b = lane.as<FrustumBlock>();
    const uint j = lane.lane;
    return {Vector(b.center[0][j], b.center[1][j], b.center[2][j]),
            Vector(b.axis[0][j], b.axis[1][j], b.axis[2][j]),
            b.half_length[j],
            b.radius[j],
            b.slope[j],
            b.side[j] < 0};
}

class FrustumOracle final : public PrimitiveOracle {
public:
    const PrimitiveKind &kind() const override { return frustum_kind; }

    /// A cone, a cylinder or a frustum, of some only the inside; its ends are up to 8 sizes apart.
    std::unique_ptr<Shape> make(InputSource &source, vec3 place, float size) const override {
        const vec3 apex = place + source.direction() * (size * source.power_of_two(-3, 3));
        const float base_radius = size * source.uniform(0.1, 1), apex_radii[] = {base_radius, 0, size * source.uniform(0, 1)};
        const float apex_radius = apex_radii[source.below(3)], side = source.one_in(5) ? -1.0f : 1.0f;
        return make_frustum(0, place, side * base_radius, apex, side * apex_radius);
    }

    Aim aim(InputSource &source, Lane lane) const override {
        const FrustumBlock &b = lane.as<FrustumBlock>();
        const uint j = lane.lane;
        const glm::dvec3 center(b.center[0][j], b.center[1][j], b.center[2][j]), axis(b.axis[0][j], b.axis[1][j], b.axis[2][j]);
        const glm::dvec3 x = glm::cross(axis, glm::dvec3(source.direction()));
        const glm::dvec3 outward = glm::length(x) > 0 ? glm::normalize(x) : glm::dvec3(0);
        const float z = b.half_length[j] * (source.one_in(4) ? source.sign() : source.uniform(-1.1, 1.1));  // rims and tips
        const float radius = b.radius[j] + b.slope[j] * z;
        return {vec3(center + axis * double(z) + outward * double(radius)), vec3(glm::normalize(outward - axis * double(b.slope[j])))};
    }

    /// Rounding, with u = 2^-24, f = o - c, k = 1 + s^2: the kernel's m, the ray's point nearest to the centre, is off by e = 4 u |f| across the
    /// ray (f, the product and the sum), its z and x by 4 u |m| more, and z by 2 u |z| since the axis has unit length only but for rounding. Its
    /// coefficients of F(t) = a t^2 + 2 b t + c are off by da = 12 u k d^2, db = 12 u k d (m + r) + k d e, dc = 12 u (k m^2 + r^2) + 2 k (m + r) e,
    /// so F(t) by dF = da t^2 + 2 db |t| + dc, and a root by dF / |F'(t)| as long as that is small against the distance to the other root, and by
    /// sqrt(2 dF / |a|) else. The sum with the nearest point's t adds 4 u (|f| / d + |t|).
    std::vector<Root> roots(Lane lane, const Ray &ray) const override {
        const Frustum record = frustum_of(lane);
        const Vector d = ray.direction, f = Vector(ray.origin) - record.center, axis = record.unit_axis();
        const extended u = unit_roundoff, dd = dot(d, d), d_length = square_root(dd), f_length = length(f), nearest = -dot(f, d) / dd;
        const Vector m = f + d * nearest, dx = cross(d, axis), mx = cross(m, axis);
        const extended dz = dot(d, axis), mz = dot(m, axis), s = record.slope, r = record.radius_at(mz), k = 1 + s * s;
        const extended a = dot(dx, dx) - s * dz * s * dz, b = dot(mx, dx) - s * dz * r, c = dot(mx, mx) - r * r;
        const extended e = 4 * u * f_length, size = length(m) + absolute(r) + record.radius;
        const extended da = 12 * u * k * dd, db = 12 * u * k * d_length * size + k * d_length * e, dc = 12 * u * k * size * size + 2 * k * size * e;
        const extended discriminant = b * b - a * c, derror = 2 * absolute(b) * db + db * db + absolute(a) * dc + absolute(c) * da + da * dc;
        if (discriminant < -derror) return {};

        const extended root = square_root(discriminant), q = -(b < 0 ? b - root : b + root);
        const extended fz = dot(f, axis), fr = record.radius_at(fz), fx = length(cross(f, axis));
        const bool may_start_on = absolute(fx * fx - fr * fr) <= 0x1p-19 * absolute(fr) * (absolute(fr) + absolute(fz)) + 2 * dc;
        std::array<Root, 2> candidates;
        for (int i = 0; i < 2; ++i) {
            const extended t = i == 0 ? q / a : c / q, df = da * t * t + 2 * db * absolute(t) + dc;
            const bool apart = discriminant > derror && df * absolute(a) < root * root / 4;
            const extended error = apart ? df / root : 2 * square_root((df + derror / absolute(a)) / absolute(a));
            candidates[std::size_t(i)] = {nearest + t, error + 4 * u * (f_length / d_length + absolute(t)), apart};
        }
        std::vector<Root> roots;
        for (std::size_t i = 0; i < 2; ++i) {
            const auto [t, error, apart] = candidates[i];
            if (!is_finite(t)) continue;
            const extended z = mz + (t - nearest) * dz, at_z = absolute(dz) * error + 8 * u * (absolute(z) + f_length);
            if (absolute(z) > record.half_length + at_z) continue;
            const extended radius = record.radius_at(z), at_radius = absolute(s) * at_z + 4 * u * (record.radius + absolute(s * z));
            if (radius < -at_radius) continue;
            const extended gradient = a * (t - nearest) + b;
            if (record.inside_only && apart && gradient < 0) continue;
            const bool may_be_start = may_start_on && absolute(t) <= absolute(candidates[1 - i].t) + error;
            roots.push_back({t, error, apart && !may_be_start && absolute(z) < record.half_length - at_z && radius > at_radius});
        }
        return roots;
    }

    extended distance(Lane lane, Vector point) const override {
        const Frustum record = frustum_of(lane);
        const Vector p = point - record.center;
        return (record.across(p) - record.radius_at(record.place(p))) / square_root(1 + record.slope * record.slope);
    }

    /// The point that is put back, o + t d - c, is off by 8 u (|f| + t |d|), and its direction from the axis by that over its distance from the axis.
    Normal normal_on(Lane lane, const Ray &ray, extended t) const override {
        const Frustum record = frustum_of(lane);
        const Vector f = Vector(ray.origin) - record.center, d = ray.direction, there = f + d * t, axis = record.unit_axis();
        const extended error = 16 * unit_roundoff * (length(f) + t * length(d)) / record.across(there) + 8 * unit_roundoff;
        return {unit(unit(there - axis * dot(there, axis)) - axis * record.slope), error};
    }

    /// u from the direction across the axis that lies in the plane of its larger component of x and z, and y; v from end to end. f is off by
    /// e = 8 u (|f| + t |d|), and the axes have roundings of their own: parts of f along them are off by e + 10 u |f|.
    Place place_on(Lane lane, const Ray &ray, extended t) const override {
        const Frustum record = frustum_of(lane);
        const Vector start = Vector(ray.origin) - record.center, d = ray.direction, f = start + d * t, axis = record.unit_axis();
        const Vector x = unit(absolute(axis.x) > absolute(axis.z) ? Vector(-axis.y, axis.x, 0) : Vector(0, -axis.z, axis.y)), y = cross(axis, x);
        const extended error = 8 * unit_roundoff * (length(start) + t * length(d)) + 10 * unit_roundoff * length(f);
        const long double angle = std::atan2((long double)(dot(f, y)), (long double)(dot(f, x)));
        const extended v = 0.5 + dot(f, axis) / (2 * record.half_length);
        return {{0.5L + angle / (2 * std::numbers::pi_v<long double>), v},
                {0.25 * error / record.across(f) + 4 * unit_roundoff, error / (2 * record.half_length) + 4 * unit_roundoff * (1 + absolute(v))}};
    }

    /// p is put together from the centre, a place on the axis and the way outward, as the kernel has it; its coordinates' rounding turns that.
    Normal normal_at(Lane lane, Vector point) const override {
        const Frustum record = frustum_of(lane);
        const Vector p = point - record.center, axis = record.unit_axis();
        const extended size = largest(point) + largest(record.center) + record.half_length + record.radius;
        return {unit(unit(p - axis * dot(p, axis)) - axis * record.slope), 16 * unit_roundoff * size / record.across(p) + 8 * unit_roundoff};
    }

    extended beyond_ends(Lane lane, Vector point) const override {
        const Frustum record = frustum_of(lane);
        return greater(absolute(record.place(point - record.center)) - record.half_length, 0);
    }

    /// Uniform.
    Density inverse_density(Lane lane, Vector, Vector, extended, extended) const override {
        const Frustum record = frustum_of(lane);
        const extended slant = square_root(1 + record.slope * record.slope);
        return {4 * std::numbers::pi_v<long double> * record.radius * record.half_length * slant, 8 * unit_roundoff};
    }

    extended room(Lane lane, Vector point) const override {
        const Frustum record = frustum_of(lane);
        return record.across(point - record.center);
    }
};

}  // namespace

std::unique_ptr<PrimitiveOracle> make_frustum_oracle() { return std::make_unique<FrustumOracle>(); }

}  // namespace brandung
