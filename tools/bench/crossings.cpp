#include "tools/bench/crossings.h"

#include <algorithm>
#include <cmath>

namespace brandung {
namespace {

using glm::dvec3;

constexpr double slip_in_world = 0x1p-21, slip_in_group = 0x1p-18;

/// Adds it unless it is certainly outside of the ray.
void add(std::vector<Crossing> &crossings, const RayInSpace &ray, Crossing crossing) {
    if (crossing.last < 0 || crossing.first > ray.t_max) return;
    crossing.within = crossing.first > 0 && crossing.last < ray.t_max;
    crossing.certain &= crossing.within;
    crossings.push_back(crossing);
}

/// By where the ray passes the outline as it sees it. A corner that is seen beside its place moves the plane's crossing by that times the slope, but
/// never beyond the corners.
void add_triangle(std::vector<Crossing> &crossings, const RayInSpace &ray, const GeometryPrimitive &triangle, Crossing crossing) {
    const auto [a, b, c] = seen_corners(ray, triangle);
    crossing.slip = slip_within(ray, std::max({glm::length(a), glm::length(b), glm::length(c)}));
    const double u = turn(b, c), v = turn(c, a), w = turn(a, b), area = u + v + w;
    const bool inside = area != 0 && std::min({u * area, v * area, w * area}) >= 0;
    const double edge = std::min({distance_from_edge(a, b), distance_from_edge(b, c), distance_from_edge(c, a)});
    if (!inside && edge > crossing.slip) return;
    crossing.certain = inside && edge > crossing.slip;
    const double nearest = std::min({a.z, b.z, c.z}) - crossing.slip, farthest = std::max({a.z, b.z, c.z}) + crossing.slip;
    const dvec3 normal = glm::cross(b - a, c - a);
    const double z = glm::dot(normal, a) / normal.z,
                 error = crossing.slip * 2 * (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z)) / std::abs(normal.z);
    const bool has_plane = std::isfinite(z) && std::isfinite(error);
    crossing.first = (has_plane ? std::clamp(z - error, nearest, farthest) : nearest) / ray.length;
    crossing.last = (has_plane ? std::clamp(z + error, nearest, farthest) : farthest) / ray.length;
    crossing.t = std::clamp(has_plane ? z / ray.length : 0.0, crossing.first, crossing.last);
    add(crossings, ray, crossing);
}

/// By how far from its centre the ray passes.
void add_sphere(std::vector<Crossing> &crossings, const RayInSpace &ray, const GeometryPrimitive &sphere, Crossing crossing) {
    const dvec3 to_centre = dvec3(sphere.a) - ray.origin;
    const double radius = std::abs(double(sphere.b.x)), middle = glm::dot(to_centre, ray.direction) / ray.length;
    const double beside = glm::length(to_centre - middle / ray.length * ray.direction);
    crossing.slip = slip_within(ray, glm::length(to_centre) + radius);
    if (beside > radius + crossing.slip) return;
    crossing.certain = beside < radius - crossing.slip;
    const auto half = [&](double distance) { return std::sqrt(std::max((radius - distance) * (radius + distance), 0.0)); };
    const double least = half(beside + crossing.slip) - crossing.slip, most = half(std::max(beside - crossing.slip, 0.0)) + crossing.slip;
    if (sphere.b.x > 0) {
        crossing.t = (middle - half(beside)) / ray.length, crossing.first = (middle - most) / ray.length,
        crossing.last = (middle - least) / ray.length;
        add(crossings, ray, crossing);
    }
    crossing.t = (middle + half(beside)) / ray.length, crossing.first = (middle + least) / ray.length, crossing.last = (middle + most) / ray.length;
    add(crossings, ray, crossing);
}

}  // namespace

RayInSpace ray_in_world(const Ray &ray) {
    const dvec3 direction(ray.direction);
    return {dvec3(ray.origin), direction, double(ray.t_max), 0, slip_in_world, glm::length(direction)};
}

RayInSpace ray_in_group(const Ray &ray, const Transform &to_group) {
    const glm::dmat3 linear(dvec3(to_group.x), dvec3(to_group.y), dvec3(to_group.z));
    const glm::dmat3 sizes(glm::abs(linear[0]), glm::abs(linear[1]), glm::abs(linear[2]));
    const dvec3 origin(ray.origin), offset(to_group.origin), direction = linear * dvec3(ray.direction);
    const double length = glm::length(direction);
    return {linear * origin + offset,
            direction,
            double(ray.t_max),
            slip_in_group * glm::length(sizes * glm::abs(origin) + glm::abs(offset)),
            slip_in_group * glm::length(sizes * glm::abs(dvec3(ray.direction))) / length,
            length};
}

double slip_within(const RayInSpace &ray, double reach) { return ray.origin_error + ray.slip * reach; }

std::array<dvec3, 3> seen_corners(const RayInSpace &ray, const GeometryPrimitive &triangle) {
    const dvec3 z = ray.direction / ray.length;
    const dvec3 x = glm::normalize(glm::cross(std::abs(z.x) > 0.5 ? dvec3(0, 1, 0) : dvec3(1, 0, 0), z)), y = glm::cross(z, x);
    const auto seen = [&](const vec3 &corner) {
        const dvec3 from_origin = dvec3(corner) - ray.origin;
        return dvec3(glm::dot(from_origin, x), glm::dot(from_origin, y), glm::dot(from_origin, z));
    };
    return {seen(triangle.a), seen(triangle.b), seen(triangle.c)};
}

double distance_from_edge(dvec3 p, dvec3 q) {
    const glm::dvec2 from(p), along = glm::dvec2(q) - from;
    const double squared = glm::dot(along, along);
    const double part = squared == 0 ? 0 : std::clamp(-glm::dot(from, along) / squared, 0.0, 1.0);
    return glm::length(from + part * along);
}

void add_crossings(std::vector<Crossing> &crossings, const RayInSpace &ray, const GeometryPrimitive &primitive, uint number, uint instance) {
    const Crossing crossing = {number, instance, 0, 0, 0, false, false, 0};
    if (primitive.kind == GeometryPrimitive::Kind::triangle) add_triangle(crossings, ray, primitive, crossing);
    if (primitive.kind == GeometryPrimitive::Kind::sphere) add_sphere(crossings, ray, primitive, crossing);
}

}  // namespace brandung
