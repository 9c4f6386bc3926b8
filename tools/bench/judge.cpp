#include "tools/bench/judge.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brandung {
namespace {

using glm::dvec3;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where a ray may meet a primitive, as far as tracers in float can tell.
struct Crossing {
    uint primitive, instance;
    double t, error;
    bool certain;  ///< no tracer in float may miss it
};

/// A ray in the space of primitives, and the magnitudes of the terms whose sums its coordinates are.
struct RayInSpace {
    dvec3 origin, direction;
    dvec3 origin_terms, direction_terms;
    double t_max;
    double rounding;  ///< of sums of products, relative to these' magnitudes
};

RayInSpace in_world(const Ray &ray) {
    const dvec3 direction(ray.direction);
    return {dvec3(ray.origin), direction, dvec3(0), glm::abs(direction), double(ray.t_max), 0x1p-20};
}

RayInSpace in_group(const Ray &ray, const Transform &to_group) {
    const glm::dmat3 linear(dvec3(to_group.x), dvec3(to_group.y), dvec3(to_group.z));
    const glm::dmat3 sizes(glm::abs(linear[0]), glm::abs(linear[1]), glm::abs(linear[2]));
    const dvec3 origin(ray.origin), direction(ray.direction), offset(to_group.origin);
    return {linear * origin + offset,    linear * direction, sizes * glm::abs(origin) + glm::abs(offset),
            sizes * glm::abs(direction), double(ray.t_max),  0x1p-18};
}

/// The magnitudes of the terms of a cross product.
dvec3 cross_terms(dvec3 a, dvec3 b) { return {a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x}; }

/// 1 or -1; 0 where it cannot be told.
int sign_of(double value, double error) { return value > error ? 1 : value < -error ? -1 : 0; }

/// Adds it unless it is certainly outside of the ray.
void add(std::vector<Crossing> &crossings, const RayInSpace &ray, Crossing crossing) {
    if (crossing.t + crossing.error < 0 || crossing.t - crossing.error > ray.t_max) return;
    crossing.certain &= crossing.t - crossing.error > 0 && crossing.t + crossing.error < ray.t_max;
    crossings.push_back(crossing);
}

/// By the volumes that the ray spans with the edges, and the plane.
void add_triangle(std::vector<Crossing> &crossings, const RayInSpace &ray, const GeometryPrimitive &triangle, Crossing crossing) {
    const dvec3 a = dvec3(triangle.a) - ray.origin, b = dvec3(triangle.b) - ray.origin, c = dvec3(triangle.c) - ray.origin;
    const dvec3 terms_a = glm::abs(a) + ray.origin_terms, terms_b = glm::abs(b) + ray.origin_terms, terms_c = glm::abs(c) + ray.origin_terms;
    const auto side = [&](dvec3 p, dvec3 q, dvec3 terms_p, dvec3 terms_q) {
        return sign_of(glm::dot(ray.direction, glm::cross(p, q)), ray.rounding * glm::dot(ray.direction_terms, cross_terms(terms_p, terms_q)));
    };
    const int u = side(b, c, terms_b, terms_c), v = side(c, a, terms_c, terms_a), w = side(a, b, terms_a, terms_b);
    if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0) return;
    crossing.certain = u == v && v == w && u != 0;
    const dvec3 normal = glm::cross(b - a, c - a), terms = cross_terms(glm::abs(b - a), glm::abs(c - a));
    const double slope = glm::dot(normal, ray.direction), slope_error = ray.rounding * glm::dot(terms, ray.direction_terms);
    crossing.t = slope == 0 ? 0 : glm::dot(normal, a) / slope;
    crossing.error = std::abs(slope) <= slope_error
                         ? infinity
                         : (ray.rounding * glm::dot(terms, terms_a) + std::abs(crossing.t) * slope_error) / (std::abs(slope) - slope_error);
    add(crossings, ray, crossing);
}

/// By the distance of its centre from the ray. Of a negative radius only the inside is visible: the far crossing.
void add_sphere(std::vector<Crossing> &crossings, const RayInSpace &ray, const GeometryPrimitive &sphere, Crossing crossing) {
    const dvec3 from_centre = ray.origin - dvec3(sphere.a);
    const double radius = double(sphere.b.x), squared = glm::dot(ray.direction, ray.direction),
                 middle = -glm::dot(from_centre, ray.direction) / squared;
    const double reach = glm::length(glm::abs(from_centre) + ray.origin_terms);
    const dvec3 nearest = from_centre + middle * ray.direction;
    const double inside = radius * radius - glm::dot(nearest, nearest), inside_error = 4 * ray.rounding * (reach * reach + radius * radius);
    if (inside < -inside_error) return;
    const double half = std::sqrt(std::max(inside, 0.0) / squared);
    const double half_error = std::min(std::sqrt(inside_error / squared), inside_error / (squared * half));
    crossing.error = half_error + 4 * ray.rounding * reach * glm::length(ray.direction_terms) / squared;
    crossing.certain = inside > inside_error;
    for (const double t : {middle - half, middle + half}) {
        if (radius < 0 && t < middle) continue;
        crossing.t = t;
        add(crossings, ray, crossing);
    }
}

std::vector<Crossing> crossings_of(const SceneGeometry &geometry, const Ray &ray) {
    std::vector<Crossing> crossings;
    const uint spaces = std::max(1u, static_cast<uint>(geometry.instances.size()));
    for (uint instance = 0; instance < spaces; ++instance) {
        const RayInSpace here = instance == 0 ? in_world(ray) : in_group(ray, geometry.instances[instance].to_group);
        const GeometrySpace &space = geometry.space_of(instance);
        for (uint i = space.first; i < space.end; ++i) {
            const GeometryPrimitive &primitive = geometry.primitives[i];
            const Crossing crossing = {i, instance, 0, 0, false};
            primitive.kind == GeometryPrimitive::Kind::sphere ? add_sphere(crossings, here, primitive, crossing)
                                                              : add_triangle(crossings, here, primitive, crossing);
        }
    }
    return crossings;
}

/// Whether some crossing that no tracer may miss is before all that t may be.
bool is_behind(const std::vector<Crossing> &crossings, double least) {
    return std::ranges::any_of(crossings, [&](const Crossing &c) { return c.certain && c.t + c.error < least; });
}

bool is_wrong(const std::vector<Crossing> &crossings, bool any, const Claim &claim) {
    if (!claim.meets) return is_behind(crossings, infinity);
    if (any) return crossings.empty();
    return std::ranges::none_of(crossings, [&](const Crossing &c) {
        return c.primitive == claim.primitive && c.instance == claim.instance && std::abs(double(claim.t) - c.t) <= c.error &&
               !is_behind(crossings, c.t - c.error);
    });
}

}  // namespace

std::vector<Verdict> judge(const SceneGeometry &geometry, std::span<const Dispute> disputes) {
    std::vector<Verdict> verdicts(disputes.size());
    tbb::parallel_for(std::size_t{0}, disputes.size(), [&](std::size_t i) {
        const Dispute &dispute = disputes[i];
        const std::vector<Crossing> crossings = crossings_of(geometry, dispute.ray);
        verdicts[i] = {is_wrong(crossings, dispute.any, dispute.ours), is_wrong(crossings, dispute.any, dispute.theirs)};
    });
    return verdicts;
}

}  // namespace brandung
