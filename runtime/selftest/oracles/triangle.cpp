/// Triangles in extended precision: t by the plane, inside or not by the projection along the ray; the kernel does both by sheared edge functions.
#include "kernels/primitives/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/selftest/oracles/oracles.h"
#include "scene/primitives/kinds.h"

namespace brandung {
namespace {

using Corners = std::array<vec3, 3>;

Corners corners_of(Lane lane) {
    const TriangleBlock &block = lane.as<TriangleBlock>();
    const uint j = lane.lane;
    return {vec3(block.a[0][j], block.a[1][j], block.a[2][j]), vec3(block.b[0][j], block.b[1][j], block.b[2][j]),
            vec3(block.c[0][j], block.c[1][j], block.c[2][j])};
}

Vector normal_of(const Corners &v) { return cross(Vector(v[1]) - Vector(v[0]), Vector(v[2]) - Vector(v[0])); }

glm::dvec3 in_double(Vector v) { return {double(v.x), double(v.y), double(v.z)}; }

/// Square of the distance from the origin to the segment from p to q, in double: right to 2^-50 of the larger one's square.
double square_to_segment(Vector from, Vector to) {
    const glm::dvec3 p = in_double(from), along = in_double(to - from);
    const double square = glm::dot(along, along), s = square > 0 ? glm::clamp(-glm::dot(p, along) / square, 0.0, 1.0) : 0;
    const glm::dvec3 nearest = p + along * s;
    return glm::dot(nearest, nearest);
}

/// Rounding, with u = 2^-24 and M the largest coordinate of a vertex seen from the origin: a sheared coordinate is off by 6 u M (two differences,
/// |shear| <= 1 and its product), so the ray passes a vertex at a distance that is off by 9 u M at most. Within that of an edge, and a hundredth for
/// its square, which is about 2^-42 M^2 and computed to 2^-50 M^2, anything goes.
/// z, which is t times the direction's largest component, is the mean of the vertices' z with weights that are right for such vertices to 8 u: the
/// point lies in the true plane but for (9 + 16) u M, times the plane's slope, which is at most 1 / cosine; and the mean itself is off by 8 u M.
/// A ray whose cosine is as small as the rounding of the normal lies in the plane, as far as floats can tell: it may be met anywhere in the box.
class TriangleOracle : public PrimitiveOracle {
public:
    const PrimitiveKind &kind() const override { return triangle_kind; }

    std::unique_ptr<Shape> make(InputSource &source, vec3 place, float size) const override {
        return make_triangle_mesh(0, MeshData{.positions = corners(source, place, size), .indices = {0, 1, 2}});
    }

    Aim aim(InputSource &source, Lane lane) const override {
        const Corners v = corners_of(lane);
        const vec3 n = vec3(glm::normalize(glm::cross(glm::dvec3(v[1]) - glm::dvec3(v[0]), glm::dvec3(v[2]) - glm::dvec3(v[0]))));
        const uint i = source.below(3);
        const float s = source.uniform(0, 1);
        if (source.one_in(8)) return {v[i], n};
        const vec3 on_edge = v[i] + (v[(i + 1) % 3] - v[i]) * s;
        if (source.one_in(4)) return {on_edge, n};
        return {on_edge + (v[(i + 2) % 3] - on_edge) * source.uniform(-0.1, 1), n};
    }

    std::vector<Root> roots(Lane lane, const Ray &ray) const override {
        const Corners v = corners_of(lane);
        const Vector d = ray.direction, o = ray.origin, n = normal_of(v);
        const std::array<Vector, 3> seen = {Vector(v[0]) - o, Vector(v[1]) - o, Vector(v[2]) - o};
        const extended dd = dot(d, d), d_length = square_root(dd), u = unit_roundoff, dn = dot(d, n);
        const extended farthest = greater(largest(seen[0]), greater(largest(seen[1]), largest(seen[2])));
        const extended cosine = absolute(dn) / (d_length * length(n));
        const bool in_plane = cosine < 16 * u;

        std::array<Vector, 3> across = seen;
        for (Vector &w : across) w = w - d * (dot(w, d) / dd);
        const double to_edges =
            std::min({square_to_segment(across[0], across[1]), square_to_segment(across[1], across[2]), square_to_segment(across[2], across[0])});
        bool positive = true, negative = true;
        for (uint i = 0; i < 3; ++i) {
            const extended side = dot(d, cross(across[i], across[(i + 1) % 3]));
            positive &= side >= 0, negative &= side <= 0;
        }
        const extended doubtful = 9.1 * u * farthest;
        const bool inside = positive || negative, near_edge = to_edges <= doubtful * doubtful;
        if (!(inside || near_edge)) return {};
        if (in_plane) return {{dot(seen[0], d) / dd, 4 * farthest / d_length, false}};
        return {{dot(seen[0], n) / dn, u * farthest * (25 / cosine + 14) / d_length, inside && !near_edge}};
    }

    extended distance(Lane lane, Vector p) const override {
        const Corners v = corners_of(lane);
        return dot(p - Vector(v[0]), unit(normal_of(v)));
    }

    Normal normal_on(Lane lane, const Ray &, extended) const override { return normal_at(lane, Vector(0, 0, 0)); }

    /// The edges are rounded to u of their length, or exact; then n = e x f is off by 4 u |e| |f| in each component, however small |n| is,
    /// and its direction by 4 sqrt(3) u |e| |f| / |n|; unit() adds 4 u.
    Normal normal_at(Lane lane, Vector) const override {
        const Corners v = corners_of(lane);
        const Vector n = normal_of(v), e = Vector(v[1]) - Vector(v[0]), f = Vector(v[2]) - Vector(v[0]);
        const extended n_length = length(n);
        return {n * (1 / n_length), 12 * unit_roundoff * length(e) * length(f) / n_length + 8 * unit_roundoff};
    }

    /// The ray passes every vertex at a place that is off by 9 u M at most, so it meets the triangle of such vertices with weights that, for the true
    /// ones, are those of a place as far away: off by that over the height of the triangle as the ray sees it. Quotients have 12 u of their own.
    Place place_on(Lane lane, const Ray &ray, extended) const override {
        const Corners v = corners_of(lane);
        const Vector d = ray.direction, o = ray.origin;
        const std::array<Vector, 3> seen = {Vector(v[0]) - o, Vector(v[1]) - o, Vector(v[2]) - o};
        const extended d_length = length(d), area = absolute(dot(d, normal_of(v))) / d_length;
        const extended doubtful = 9 * unit_roundoff * greater(largest(seen[0]), greater(largest(seen[1]), largest(seen[2])));
        Place place{{0, 0}, {1, 1}};
        for (uint i = 0; i < 2 && area > 0; ++i) {
            const Vector &from = seen[(i + 2) % 3], &to = seen[i];
            place.uv[i] = dot(d, cross(from, to)) / dot(d, normal_of(v));
            place.error[i] = doubtful * length(cross(to - from, d)) / (d_length * area) + 12 * unit_roundoff * absolute(place.uv[i]);
        }
        return place;
    }

    extended beyond_ends(Lane lane, Vector p) const override {
        const Corners v = corners_of(lane);
        const Vector n = normal_of(v);
        double square = 0;
        bool inside = true;
        for (uint i = 0; i < 3; ++i) {
            const Vector from = Vector(v[i]) - p, to = Vector(v[(i + 1) % 3]) - p;
            inside &= dot(n, cross(from, to)) >= 0;
            const double to_edge = square_to_segment(from, to);
            square = i == 0 ? to_edge : std::min(square, to_edge);
        }
        return inside ? 0 : std::sqrt(square);
    }

    /// Uniform; areas are made in double, of edges that are rounded to u of their lengths.
    Density inverse_density(Lane lane, Vector, Vector, extended, extended) const override {
        const Corners v = corners_of(lane);
        const Vector e = Vector(v[1]) - Vector(v[0]), f = Vector(v[2]) - Vector(v[0]);
        const extended area = length(normal_of(v)) / 2;
        return {area, 4 * unit_roundoff * length(e) * length(f) / area};
    }

    extended room(Lane, Vector) const override { return std::numeric_limits<double>::infinity(); }

protected:
    /// Some slivers, of aspect up to 2^16; some in planes of two axes.
    static std::vector<vec3> corners(InputSource &source, vec3 place, float size) {
        const float thin = source.one_in(4) ? source.power_of_two(-16, 0) : 1;
        vec3 e = source.direction() * size, f = e * source.uniform(0, 1) + source.direction() * (size * thin);
        if (source.one_in(8)) {
            const uint axis = source.below(3);
            e[int(axis)] = f[int(axis)] = 0;
        }
        return {place, place + e, place + f};
    }
};

class SmoothTriangleOracle final : public TriangleOracle {
public:
    const PrimitiveKind &kind() const override { return smooth_triangle_kind; }

    std::unique_ptr<Shape> make(InputSource &source, vec3 place, float size) const override {
        return make_triangle_mesh(0, MeshData{.positions = corners(source, place, size),
                                              .normals = {source.direction(), source.direction(), source.direction()},
                                              .indices = {0, 1, 2}});
    }

    /// A mean by weights, of which the first is the rest and has the others' errors; 4 roundings of its terms, and of unit length.
    Normal shading_normal_on(Lane lane, const VertexNormals &normals, const Ray &ray, extended t) const override {
        const auto [uv, error] = place_on(lane, ray, t);
        const Vector a = normals.a, b = normals.b, c = normals.c, n = a * (1 - uv[0] - uv[1]) + b * uv[0] + c * uv[1];
        const extended rounding = 4 * unit_roundoff * (absolute(1 - uv[0] - uv[1]) + absolute(uv[0]) + absolute(uv[1]));
        const extended off = (error[0] + error[1]) * length(a) + error[0] * length(b) + error[1] * length(c) + rounding;
        return {unit(n), 2 * off / length(n) + 8 * unit_roundoff};
    }
};

}  // namespace

std::unique_ptr<PrimitiveOracle> make_triangle_oracle() { return std::make_unique<TriangleOracle>(); }
std::unique_ptr<PrimitiveOracle> make_smooth_triangle_oracle() { return std::make_unique<SmoothTriangleOracle>(); }

}  // namespace brandung
