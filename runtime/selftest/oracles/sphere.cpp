/// Spheres in extended precision: crossings by the distance between centre and line as a cross product, which the kernel does not use.
#include "kernels/primitives/sphere.h"

#include <cmath>
#include <numbers>

#include "runtime/selftest/oracles/oracles.h"
#include "scene/primitives/kinds.h"

namespace brandung {
namespace {

struct Sphere {
    Vector center;
    extended radius;
    bool inside_only;
};

Sphere sphere_of(Lane lane) {
    const SphereBlock &block = lane.as<SphereBlock>();
    const uint j = lane.lane;
    return {Vector(block.x[j], block.y[j], block.z[j]), absolute(block.radius[j]), block.radius[j] < 0};
}

/// Rounding, with u = 2^-24, f = o - c, lengths along the ray (t |d|), r the radius:
/// f is exact to u |f|; b = -f.d has 3 operations of relative error u on terms that sum to |f| |d|, b / a 4 more: together, the foot of the
/// perpendicular m is off by e <= 12 u |f|. Then D = r^2 - m^2 is off by dD <= 2 m e + e^2 + 4 u (r^2 + m^2), and sqrt(D) by min(sqrt(dD), dD /
/// sqrt(D)): together with 4 u |f| of b that is the error of q = b +- sqrt(D), and of the root q / a.
/// The other root is c / q, where c = f^2 - r^2 is right to 2^-42 (f^2 + r^2): small roots keep their digits, and the side on which a ray begins
/// is never mistaken.
class SphereOracle final : public PrimitiveOracle {
public:
    const PrimitiveKind &kind() const override { return sphere_kind; }

    std::unique_ptr<Shape> make(InputSource &source, vec3 place, float size) const override {
        return make_sphere(0, place, source.one_in(5) ? -size : size);
    }

    Aim aim(InputSource &source, Lane lane) const override {
        const SphereBlock &block = lane.as<SphereBlock>();
        const uint j = lane.lane;
        const vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        const vec3 n = source.one_in(8) ? axes[source.below(3)] * source.sign() : source.direction();
        const float r = std::abs(block.radius[j]) * (source.one_in(2) ? 1 : source.uniform(0.9, 1.1));
        return {vec3(block.x[j], block.y[j], block.z[j]) + r * n, n};
    }

    std::vector<Root> roots(Lane lane, const Ray &ray) const override {
        const auto [center, r, inside_only] = sphere_of(lane);
        const Vector d = ray.direction, f = Vector(ray.origin) - center;
        const extended u = unit_roundoff, a = dot(d, d), d_length = square_root(a), ff = dot(f, f), f_length = square_root(ff);
        const Vector across = cross(f, d);
        const extended mm = dot(across, across) / a, m = square_root(mm), b = -dot(f, d) / d_length;
        const extended e = 12 * u * f_length, discriminant = r * r - mm;
        const extended error = 2 * greater(m, r) * e + e * e + 4 * u * (r * r + mm);
        if (discriminant < -error) return {};
        const bool sure = discriminant > error;
        const extended half = square_root(discriminant), rough = square_root(error);
        const extended half_error = sure ? lesser(rough, error / half) : 2 * rough;
        const extended q = absolute(b) + half, q_error = half_error + 8 * u * (f_length + r);
        const extended large = (b < 0 ? -q : q) / d_length, small = (ff - r * r) / (b < 0 ? -q : q) / d_length;
        const extended large_error = q_error / d_length + 4 * u * absolute(large);
        // Where q itself may vanish, both roots do, but for what q's error makes of them.
        const extended small_error = q > 2 * q_error ? absolute(small) * (2 * q_error / q + 4 * u) + 0x1p-41 * (ff + r * r) / q / d_length
                                                     : 4 * (q + q_error) / d_length + absolute(small);
        const bool large_is_far = large > small;
        const Root of_large{large, large_error, sure}, of_small{small, small_error, sure};
        if (inside_only) return {large_is_far ? of_large : of_small};
        return {of_large, of_small};
    }

    extended distance(Lane lane, Vector p) const override {
        const Sphere sphere = sphere_of(lane);
        return length(p - sphere.center) - sphere.radius;
    }

    /// o + t d - c has 3 roundings of magnitudes up to |f| + t |d|, so the normal is off by 8 u (|f| + t |d|) / r, and by 4 u from its own length;
    /// t's own error moves the point along the ray, which is no error of the normal there.
    Normal normal_on(Lane lane, const Ray &ray, extended t) const override {
        const Sphere sphere = sphere_of(lane);
        const Vector f = Vector(ray.origin) - sphere.center, d = ray.direction;
        return {unit(f + d * t), 8 * unit_roundoff * (length(f) + t * length(d)) / sphere.radius + 4 * unit_roundoff};
    }

    /// v grows from the pole at -y to that at +y, u is 1/2 towards z and grows towards x. f is off by e = 8 u (|f| + t |d|): the angle about the y
    /// axis by e over the distance from that, the other one by e / |f|. Arctangents are off by 9 u, as angles; the rest is rounding of numbers up
    /// to 1.
    Place place_on(Lane lane, const Ray &ray, extended t) const override {
        const Vector start = Vector(ray.origin) - sphere_of(lane).center, d = ray.direction, f = start + d * t;
        const extended error = 8 * unit_roundoff * (length(start) + t * length(d)), across = square_root(f.x * f.x + f.z * f.z);
        const long double angle = std::atan2((long double)(f.x), (long double)(f.z)), height = std::atan2((long double)(f.y), (long double)(across));
        return {{0.5L + angle / (2 * std::numbers::pi_v<long double>), 0.5L + height / std::numbers::pi_v<long double>},
                {0.2 * error / across + 4 * unit_roundoff, 0.4 * error / length(f) + 6 * unit_roundoff}};
    }

    /// p is the centre and the normal, as the kernel has it, times r, but for rounding.
    Normal normal_at(Lane lane, Vector p) const override {
        const Sphere sphere = sphere_of(lane);
        return {unit(p - sphere.center), 8 * unit_roundoff * (largest(p) + largest(sphere.center)) / sphere.radius + 4 * unit_roundoff};
    }

    extended beyond_ends(Lane, Vector) const override { return 0; }

    /// From inside uniform. From outside, at the distance d, by the part that is seen, (1 - (r / d)²) pi r², over the cosine between p and `from` as
    /// the centre sees them. r / d is off by that of d, and the part by twice that over itself; the cosine by what turns both.
    Density inverse_density(Lane lane, Vector p, Vector from, extended slack, extended from_slack) const override {
        const Sphere sphere = sphere_of(lane);
        const extended r = sphere.radius, pi = std::numbers::pi_v<long double>, u = unit_roundoff;
        const Vector way = from - sphere.center;
        const extended d = length(way), ratio = r / d, seen = 1 - ratio * ratio;
        if (d < r) return {4 * pi * r * r, 8 * u};
        const extended cosine = dot(unit(p - sphere.center), unit(way)), turned = slack / r + from_slack / d + 8 * u;
        return {seen / cosine * pi * r * r, 2 * (from_slack / d + 6 * u) / seen + turned / cosine + 8 * u};
    }

    extended room(Lane lane, Vector) const override { return sphere_of(lane).radius; }
};

}  // namespace

std::unique_ptr<PrimitiveOracle> make_sphere_oracle() { return std::make_unique<SphereOracle>(); }

}  // namespace brandung
