/// In how many places a ray meets a mesh, by the faces that it is said to meet.
#pragma once
#include <span>

#include "kernels/core/items.h"
#include "scene/primitives/shape.h"

namespace brandung {

/// Faces are met in one place if they share a vertex or an edge and the ray passes that, in extended precision, as near as rounding of what it sees
/// can matter; and so are those that each are in one place with a third. Faces are numbers in the mesh.
uint places_met(const MeshData &mesh, const Ray &ray, std::span<const uint> faces);

}  // namespace brandung
