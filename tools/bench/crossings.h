/// Crossings: where a ray may meet primitives, as far as tracers in float can tell.
#pragma once
#include <array>
#include <vector>

#include "kernels/core/items.h"
#include "tools/bench/scene_geometry.h"

namespace brandung {

/// A ray in the space of primitives.
struct RayInSpace {
    glm::dvec3 origin, direction;
    double t_max;
    double origin_error;  ///< of its coordinates, which an instance's matrices have made
    double slip;          ///< how far beside its place a tracer may see a point, per distance from the origin
    double length;        ///< of the direction
};

RayInSpace ray_in_world(const Ray &ray);
RayInSpace ray_in_group(const Ray &ray, const Transform &to_group);

/// How far beside its place a tracer may see what lies within `reach` of the ray's origin.
double slip_within(const RayInSpace &ray, double reach);

/// Where a ray may meet a primitive.
struct Crossing {
    uint primitive, instance;
    double t, first, last;  ///< by the primitive as it is, and the range of what tracers may find
    bool certain;           ///< no tracer may miss it; first and last are before the ray's end and beyond its origin
    bool within;            ///< first and last are
    double slip;
};

/// What a ray may meet of one primitive: a triangle at most once, a sphere at both sides, of a negative radius only at the far one.
void add_crossings(std::vector<Crossing> &crossings, const RayInSpace &ray, const GeometryPrimitive &primitive, uint number, uint instance);

/// The corners of a triangle as a ray sees them: in its plane across, in which it is the origin, and along it.
std::array<glm::dvec3, 3> seen_corners(const RayInSpace &ray, const GeometryPrimitive &triangle);

/// Of the origin from the edge between two seen corners.
double distance_from_edge(glm::dvec3 p, glm::dvec3 q);

/// Twice the area, as it is seen, of the triangle of the origin and such an edge: positive where that runs counterclockwise around it.
inline double turn(glm::dvec3 p, glm::dvec3 q) { return p.x * (q.y - p.y) - p.y * (q.x - p.x); }

}  // namespace brandung
