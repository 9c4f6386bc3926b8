/// Faces of an emissive mesh, from which kernels choose points.
#pragma once
#include <span>
#include <vector>

#include "kernels/lights/emission.h"

namespace brandung {

/// Of triangles (three indices each, with area) over positions. Two that share an edge, make a parallelogram and have the same front are one face, so
/// that a quadrilateral light is divided into strata as a whole; a triangle is paired with the earliest one that fits. All of each face counts.
std::vector<EmissiveFace> make_emissive_faces(const std::vector<vec3> &positions, std::span<const uint> indices);

double area_of(const EmissiveFace &face);

}  // namespace brandung
