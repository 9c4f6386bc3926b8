/// Triangles in extended precision: t by the plane, inside or not by the projection along the ray; the kernel does both by sheared edge functions.
#include "kernels/primitives/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/selftest/oracles/oracles.h"
#include "runtime/selftest/segment.h"
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

/// Edge functions E = x y' - y x' of two vertices, as the ray sees them along the axis of its direction's largest component, d_z: one for each
/// vertex, whose weight it is over the sum of all three. Their signs are exact for the vertices as rounded there, of which x = (a - o)_x - (d_x /
/// d_z) (a - o)_z is off by u (|a - o|_x + 3 |d_x / d_z| |a - o|_z + |x|): two differences, a quotient, which may be subnormal and then is off by
/// 2^-149, a product, and the last difference. The exact ones are triple products d . (w x w') / d_z. Products of less than 2^-102 lose digits of
/// theirs to 2^-149.
struct EdgeFunctions {
    std::array<extended, 3> value, error;
    extended sum() const { return value[0] + value[1] + value[2]; }
    extended error_of_sum() const { return error[0] + error[1] + error[2]; }
};

EdgeFunctions edge_functions(const Corners &v, const Ray &ray) {
    const vec3 d = ray.direction, size = glm::abs(d);
    const int z = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0, axes[] = {(z + 1) % 3, (z + 2) % 3};
    std::array<std::array<extended, 2>, 3> at, off;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 2; ++k) {
            const int axis = axes[k];
            const extended across = extended(v[i][axis]) - ray.origin[axis], along = extended(d[axis]) / d[z] * (extended(v[i][z]) - ray.origin[z]);
            at[i][k] = across - along;
            off[i][k] = unit_roundoff * (absolute(across) + 3 * absolute(along) + absolute(at[i][k])) +
                        0x1p-149 * (1 + absolute(extended(v[i][z]) - ray.origin[z]));
        }
    EdgeFunctions edges;
    for (int i = 0; i < 3; ++i) {
        const int from = (i + 2) % 3, to = (i + 1) % 3;
        edges.value[i] = dot(Vector(d), cross(Vector(v[from]) - ray.origin, Vector(v[to]) - ray.origin)) / d[z];
        edges.error[i] = 0x1p-147;
        for (int k = 0; k < 2; ++k)
            edges.error[i] += off[from][k] * absolute(at[to][1 - k]) + absolute(at[from][k]) * off[to][1 - k] + off[from][k] * off[to][1 - k];
    }
    return edges;
}

/// Rounding, with u = 2^-24 and M the largest coordinate of a vertex seen from the origin: the edge functions' signs decide what is inside.
/// z, which is t times the direction's largest component, is the mean of the vertices' z with weights that are right to 8 u for vertices as far away
/// as doubtful_of_vertices M: the point lies in the true plane but for (9 + 16) u M, times the plane's slope, which is at most 1 / cosine; and the
/// mean itself is off by 8 u M. On which side of the plane the ray begins is decided to 2^-42 of the lengths that its offset is the product of.
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
        const vec3 on_edge = v[i] + (v[(i + 1) % 3] - v[i]) * s, opposite = v[(i + 2) % 3], center = (v[0] + v[1] + v[2]) * (1 / 3.0f);
        if (source.one_in(8)) return {v[i] + (center - v[i]) * source.beside(), n};
        return {on_edge + (opposite - on_edge) * (source.one_in(4) ? source.beside() : source.uniform(-0.1, 1)), n};
    }

    std::vector<Root> roots(Lane lane, const Ray &ray) const override {
        const Corners v = corners_of(lane);
        const Vector d = ray.direction, o = ray.origin, n = normal_of(v);
        const std::array<Vector, 3> seen = {Vector(v[0]) - o, Vector(v[1]) - o, Vector(v[2]) - o};
        const extended dd = dot(d, d), d_length = square_root(dd), u = unit_roundoff, dn = dot(d, n);
        const extended farthest = greater(largest(seen[0]), greater(largest(seen[1]), largest(seen[2])));
        const extended cosine = absolute(dn) / (d_length * length(n));
        const bool in_plane = cosine < 16 * u;

        const EdgeFunctions edges = edge_functions(v, ray);
        bool surely_in[] = {true, true}, maybe_in[] = {true, true};  // by positive and by negative ones
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 2; ++k) {
                const extended value = k == 0 ? edges.value[i] : -edges.value[i];
                surely_in[k] &= value > edges.error[i], maybe_in[k] &= value >= -edges.error[i];
            }
        if (!maybe_in[0] && !maybe_in[1]) return {};
        if (in_plane) return {{dot(seen[0], d) / dd, 4 * farthest / d_length, false}};
        const extended side_error =
            0x1p-41 * length(Vector(v[1]) - Vector(v[0])) * length(Vector(v[2]) - Vector(v[0])) * length(seen[0]) / absolute(dn);
        return {{dot(seen[0], n) / dn, u * farthest * (25 / cosine + 14) / d_length, surely_in[0] || surely_in[1], side_error}};
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

    /// Weights are edge functions, which are right to 2 u for vertices as rounded, over their sum, which has 2 more roundings.
    Place place_on(Lane lane, const Ray &ray, extended) const override {
        const EdgeFunctions edges = edge_functions(corners_of(lane), ray);
        const extended sum = edges.sum(), least = absolute(sum) - edges.error_of_sum();
        Place place{{0, 0}, {1, 1}};
        for (uint i = 0; i < 2 && least > 0; ++i) {
            place.uv[i] = edges.value[i + 1] / sum;
            const extended part = absolute(place.uv[i]);
            place.error[i] = (edges.error[i + 1] + part * edges.error_of_sum()) / least + 8 * unit_roundoff * part + 0x1p-149;
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
