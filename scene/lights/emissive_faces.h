/// Faces of an emissive mesh, as kernels choose among them.
#pragma once
#include <span>
#include <vector>

#include "kernels/lights/emission.h"

namespace brandung {

struct EmissiveFaces {
    std::vector<EmissiveFace> faces;
    double area = 0;  ///< of all
};

/// Of triangles (three indices each, with area) over positions. Two that share an edge and make a parallelogram are one face, so that a quadrilateral
/// light is divided into strata as a whole; a triangle is paired with the earliest one that fits.
EmissiveFaces make_emissive_faces(const std::vector<vec3> &positions, std::span<const uint> indices);

}  // namespace brandung
