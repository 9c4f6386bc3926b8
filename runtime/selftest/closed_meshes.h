/// Closed meshes of triangles, out of which no ray may get.
#pragma once
#include <vector>

#include "kernels/core/items.h"
#include "runtime/selftest/input_source.h"
#include "scene/primitives/shape.h"

namespace brandung {

struct ClosedMesh {
    const char *name;
    MeshData mesh;
    bool convex;
    std::vector<vec3> centers;  ///< of balls inside
    float radius;               ///< of these
};
const std::vector<ClosedMesh> &closed_meshes();

/// From a point inside to a vertex, a point of an edge, or one of a face, of unit length or to its end.
Ray ray_from_within(InputSource &source, const ClosedMesh &closed);

}  // namespace brandung
