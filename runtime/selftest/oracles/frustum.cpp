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

/// F(s) = x^2 - (r + slope z)^2 = a s^2 + 2 b s + c along a ray, from the point m nearest to the centre on, and how far rounding takes the kernel's
/// from it. With u = 2^-24, f = o - c, x and z the parts of m across the axis and along it:
/// m is off by e = u (|f| + |f . d| / |d| + |m|) across the ray (f, the product, the sum); its place along the ray is known as rounded, but it lies
/// up to w = 8 u |f| farther, which sizes below include. Parts along the axis have 3 roundings of the whole and 2 of the axis' length, parts across 2
/// of what is subtracted and of what remains; the other part of each is off across it, which counts only squared. Dot products have 3 roundings of
/// their magnitudes, radii 1, and last differences 1.
struct AlongRay {
    extended nearest, mz, dz, a, b, c;
    extended da, db, dc;  ///< by which coefficients are off
    bool may_start_on, surely_starts_on;

    AlongRay(const Frustum &frustum, const Ray &ray) {
        const extended u = unit_roundoff;
        const Vector d = ray.direction, f = Vector(ray.origin) - frustum.center, axis = frustum.unit_axis();
        d_length = length(d), nearest = -dot(f, d) / dot(d, d);
        const Vector m = f + d * nearest, across_d = cross(d, axis), across_m = cross(m, axis);
        dz = dot(d, axis), mz = dot(m, axis);
        const extended r = frustum.radius_at(mz), slope = absolute(frustum.slope), f_length = length(f);
        a = dot(across_d, across_d) - slope * slope * dz * dz, b = dot(across_m, across_d) - frustum.slope * dz * r;
        c = dot(across_m, across_m) - r * r, w = 8 * u * f_length;

        const extended e = u * (f_length + absolute(dot(f, d)) / d_length + length(m)), m_length = length(m) + w;
        const extended d_across = length(across_d), d_along = absolute(dz), x = length(across_m) + w, z = absolute(mz) + w,
                       width = absolute(r) + slope * w;
        const extended off_d = u * (d_along + d_across), off_x = e + u * (z + x);
        off_dz = u * (3 * d_length + 2 * d_along), off_z = e + u * (3 * m_length + 2 * z);
        const extended rise = slope * d_along, off_rise = slope * off_dz + u * rise, off_r = slope * off_z + u * width;
        da = 2 * d_across * off_d + off_d * off_d + off_dz * off_dz + 3 * u * d_across * d_across + 2 * rise * off_rise + off_rise * off_rise +
             u * (rise * rise + absolute(a));
        db = d_across * off_x + x * off_d + off_x * off_d + off_z * off_dz + 3 * u * x * d_across + width * off_rise + rise * off_r +
             off_r * off_rise + u * (rise * width + absolute(b));
        dc = 2 * x * off_x + off_x * off_x + off_z * off_z + 3 * u * x * x + 2 * width * off_r + off_r * off_r + u * (width * width + absolute(c));
        find_start(frustum, f, length(cross(f, axis)), dot(f, axis), x + width, z);
    }

    extended discriminant_error() const { return 2 * absolute(b) * db + db * db + absolute(a) * dc + absolute(c) * da + da * dc; }
    /// By which the kernel's z is off for a given s.
    extended z_error(extended s) const { return off_z + absolute(s) * off_dz + unit_roundoff * absolute(mz + s * dz); }

    /// F is off by dF = da s^2 + 2 db |s| + dc, and 2 root is its slope, so a root moves by dF / (root + sqrt(root^2 - |a| dF)); where the roots are
    /// not apart, by sqrt(dF / |a|) or so. Computing s from coefficients takes 4 roundings of it, and t one of its own.
    Root candidate(extended s, extended root) const {
        const extended t = nearest + s, derror = discriminant_error();
        const auto moved = [&](extended s) {
            const extended reach = absolute(s) + w / d_length, df = da * reach * reach + 2 * db * reach + dc, rest = root * root - absolute(a) * df;
            return root * root > derror && rest > 0 ? df / (root + square_root(rest)) : 2 * square_root((df + derror / absolute(a)) / absolute(a));
        };
        const extended error = moved(absolute(s) + moved(s));
        return {t, error + unit_roundoff * (4 * absolute(s) + absolute(t)), root * root > derror};
    }

private:
    extended d_length, w, off_dz, off_z;

    /// By the kernel's rule and its rounding: parts of f have those of m, but for the products with d.
    void find_start(const Frustum &frustum, Vector f, extended x, extended fz, extended width_at_m, extended z_at_m) {
        const extended u = unit_roundoff, f_length = length(f), slope = absolute(frustum.slope), r = absolute(frustum.radius_at(fz)),
                       z = absolute(fz);
        const extended off_x = u * (f_length + z + x), off_fz = u * (4 * f_length + 2 * z), off_r = slope * off_fz + u * r;
        const extended off = absolute(x * x - r * r), width = r + width_at_m, rule = 0x1p-20 * width * (width + z + z_at_m);
        const extended error = 2 * x * off_x + off_x * off_x + off_fz * off_fz + 3 * u * x * x + 2 * r * off_r + off_r * off_r + u * (r * r + off);
        may_start_on = off <= 1.001 * rule + error;
        surely_starts_on = off + error <= 0.999 * rule;
    }
};

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
        const float z = b.half_length[j] * (source.one_in(4) ? source.sign() * (1 + source.beside()) : source.uniform(-1.1, 1.1));  // rims and tips
        const float radius = b.radius[j] + b.slope[j] * z;
        return {vec3(center + axis * double(z) + outward * double(radius)), vec3(glm::normalize(outward - axis * double(b.slope[j])))};
    }

    /// In the kernel's opinion a ray begins on the surface if x^2 - r^2 there is at most 2^-20 of widths and places, and then does not meet it there:
    /// what is surely such a beginning is no root.
    std::vector<Root> roots(Lane lane, const Ray &ray) const override {
        const Frustum record = frustum_of(lane);
        const AlongRay along(record, ray);
        const extended discriminant = along.b * along.b - along.a * along.c;
        if (discriminant < -along.discriminant_error()) return {};
        const extended root = square_root(discriminant), q = -(along.b < 0 ? along.b - root : along.b + root);
        const std::array<Root, 2> candidates = {along.candidate(q / along.a, root), along.candidate(along.c / q, root)};
        std::vector<Root> roots;
        for (std::size_t i = 0; i < 2; ++i) {
            const auto &[t, error, apart, side_error] = candidates[i];
            if (!is_finite(t)) continue;
            const extended s = t - along.nearest, z = along.mz + s * along.dz, at_z = absolute(along.dz) * error + along.z_error(s);
            if (absolute(z) > record.half_length + at_z) continue;
            const extended radius = record.radius_at(z), at_radius = absolute(record.slope) * at_z + unit_roundoff * record.radius;
            if (radius < -at_radius) continue;
            if (record.inside_only && apart && along.a * s + along.b < 0) continue;
            const Root &other = candidates[1 - i];
            if (along.surely_starts_on && absolute(t) + error < absolute(other.t) - other.error) continue;
            const bool may_be_start = along.may_start_on && absolute(t) - error <= absolute(other.t) + other.error;
            roots.push_back({t, error, apart && !may_be_start && absolute(z) < record.half_length - at_z && radius > at_radius});
        }
        return roots;
    }

    extended distance(Lane lane, Vector point) const override {
        const Frustum record = frustum_of(lane);
        const Vector p = point - record.center;
        return (record.across(p) - record.radius_at(record.place(p))) / square_root(1 + record.slope * record.slope);
    }

    /// The point o + t d - c is off by 2 u (|f| + t |d|), and its part across the axis by 3 u of it more: of what is subtracted, and twice of what
    /// remains, while rounding of the part along the axis is taken away by being made perpendicular once more. That, and a fifth for what is not
    /// small, turns it by its ratio to the distance from the axis.
    Normal normal_on(Lane lane, const Ray &ray, extended t) const override {
        const Frustum record = frustum_of(lane);
        const Vector f = Vector(ray.origin) - record.center, d = ray.direction, there = f + d * t, axis = record.unit_axis();
        const extended error = 6 * unit_roundoff * (length(f) + t * length(d)) / record.across(there) + 8 * unit_roundoff;
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
