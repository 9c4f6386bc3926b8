/// Open shells, which are looked into: rooms without a wall, masks.
#pragma once
#include <vector>

#include "scene/meshes/mesh_file.h"

namespace brandung {

/// The horizontal direction, of unit length, into which meshes face that surround their middle but for an opening; 0 if they do not. Rooms are looked
/// into along an axis. `up` has unit length.
glm::dvec3 opening(const std::vector<MeshPart> &parts, const glm::dvec3 &middle, const glm::dvec3 &up);

}  // namespace brandung
