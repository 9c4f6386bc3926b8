/// Disks in extended precision.
#include "kernels/primitives/disk.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "runtime/selftest/oracles/oracles.h"
#include "scene/primitives/kinds.h"

namespace brandung {
namespace {

/// What the block describes, as rounded: the normal's length is 1 only but for rounding.
struct Disk {
    Vector center, normal;
    extended radius;
    /// From the plane, over the normal's length as it is.
    extended height(Vector p) const { return dot(p - center, normal); }
    /// From the axis.
    extended aside(Vector p) const { return length(cross(p - center, normal)) / length(normal); }
    Vector unit_normal() const { return unit(normal); }
};

Disk disk_of(Lane lane) {
    const DiskBlock &b = lane.as<DiskBlock>();
    const uint j = lane.lane;
    return {Vector(b.center[0][j], b.center[1][j], b.center[2][j]), Vector(b.normal[0][j], b.normal[1][j], b.normal[2][j]), b.radius[j]};
}

/// The angle about the normal [turns], counterclockwise: 1/2 in the direction across it that lies in the plane of y and the larger one of x and z.
extended turns_about(Vector normal, Vector f) {
    const Vector x = unit(absolute(normal.x) > absolute(normal.z) ? Vector(-normal.y, normal.x, 0) : Vector(0, -normal.z, normal.y)),
                 y = cross(normal, x);
    return 0.5L + std::atan2((long double)(dot(f, y)), (long double)(dot(f, x))) / (2 * std::numbers::pi_v<long double>);
}

/// Rounding, with u = 2^-24, f = o - c, n the normal, lengths along the ray: the height n . f is right to 2^-44 |n| |f| before its last rounding, and
/// the rate n . d to 2^-44 |n| |d|, each with the subnormal parts of three products. Their quotient has 3 roundings. The place f + t d in the plane
/// has one of f, 5 of t d and one of its own, and the comparison with the radius 4 of the squares, 2 of lengths.
class DiskOracle final : public PrimitiveOracle {
public:
    const PrimitiveKind &kind() const override { return disk_kind; }

    /// Some across an axis, or all but.
    std::unique_ptr<Shape> make(InputSource &source, vec3 place, float size) const override {
        const vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        const vec3 axis = axes[source.below(3)] * source.sign(), normals[] = {source.direction(), axis, axis + source.direction() * source.beside()};
        return make_disk(0, place, normals[source.one_in(4) ? 1 + source.below(2) : 0], size * source.uniform(0.1, 1));
    }

    /// Often near the rim.
    Aim aim(InputSource &source, Lane lane) const override {
        const DiskBlock &b = lane.as<DiskBlock>();
        const uint j = lane.lane;
        const glm::dvec3 center(b.center[0][j], b.center[1][j], b.center[2][j]), normal(b.normal[0][j], b.normal[1][j], b.normal[2][j]);
        const glm::dvec3 x = glm::cross(normal, glm::dvec3(source.direction()));
        const glm::dvec3 outward = glm::length(x) > 0 ? glm::normalize(x) : glm::dvec3(0);
        const float part = source.one_in(4) ? 1 + source.beside() : source.uniform(0, 1.1);
        return {vec3(center + outward * double(b.radius[j] * part)), vec3(normal)};
    }

    /// A ray whose rate is as small as its rounding lies in the plane: it may be met anywhere on the disk.
    std::vector<Root> roots(Lane lane, const Ray &ray) const override {
        const Disk disk = disk_of(lane);
        const Vector d = ray.direction, o = ray.origin, f = o - disk.center;
        const extended u = unit_roundoff, tiny = 0x1p-147, d_length = length(d), f_length = length(f), n_length = length(disk.normal);
        const extended rate = dot(d, disk.normal), height = disk.height(o);
        const extended off_rate = 0x1p-44 * n_length * d_length + tiny, off_height = 0x1p-44 * n_length * f_length + tiny;
        if (absolute(rate) <= 2 * off_rate) {
            if (absolute(height) > 2 * off_height + off_rate * (f_length + disk.radius) / d_length) return {};
            return {{-dot(f, d) / dot(d, d), 2 * disk.radius / d_length, false}};
        }
        const extended t = -height / rate, side_error = 2 * off_height / absolute(rate);
        const extended error = 4 * u * absolute(t) + side_error + 2 * absolute(t) * off_rate / absolute(rate);
        const extended place = disk.aside(o + d * t);
        const extended off_place = 2 * u * f_length + 7 * u * absolute(t) * d_length + error * d_length + 8 * u * place + tiny;
        if (place - off_place > disk.radius) return {};
        return {{t, error, place + off_place < disk.radius, side_error}};
    }

    extended distance(Lane lane, Vector p) const override {
        const Disk disk = disk_of(lane);
        return disk.height(p) / length(disk.normal);
    }

    Normal normal_on(Lane lane, const Ray &, extended) const override { return normal_at(lane, Vector(0, 0, 0)); }

    /// o + t d - c has 3 roundings of magnitudes up to |f| + t |d|, and is made perpendicular with 5 more: it is off by e = 8 u (|f| + t |d|) across
    /// the normal; the axes have roundings of their own.
    Place place_on(Lane lane, const Ray &ray, extended t) const override {
        const Disk disk = disk_of(lane);
        const Vector start = Vector(ray.origin) - disk.center, d = ray.direction, f = start + d * t;
        const extended aside = disk.aside(disk.center + f), error = 8 * unit_roundoff * (length(start) + t * length(d)) + 10 * unit_roundoff * aside;
        return {{turns_about(disk.unit_normal(), f), lesser(aside / disk.radius, 1)},
                {0.25 * error / aside + 4 * unit_roundoff, error / disk.radius + 4 * unit_roundoff}};
    }

    /// As it is stored.
    Normal normal_at(Lane lane, Vector) const override { return {disk_of(lane).unit_normal(), 2 * unit_roundoff}; }

    extended beyond_ends(Lane lane, Vector p) const override {
        const Disk disk = disk_of(lane);
        return greater(disk.aside(p) - disk.radius, 0);
    }

    /// Uniform.
    Density inverse_density(Lane lane, Vector, Vector, extended, extended) const override {
        const Disk disk = disk_of(lane);
        return {std::numbers::pi_v<long double> * disk.radius * disk.radius, 4 * unit_roundoff};
    }

    extended room(Lane, Vector) const override { return std::numeric_limits<double>::infinity(); }
};

}  // namespace

std::unique_ptr<PrimitiveOracle> make_disk_oracle() { return std::make_unique<DiskOracle>(); }

}  // namespace brandung
