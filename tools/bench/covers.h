/// Covers: triangles of which a ray must meet one, though of each alone it may pass the edge.
#pragma once
#include <vector>

#include "tools/bench/crossings.h"

namespace brandung {

/// The farthest that some triangle of each cover may be met [t]. Covers are triangles of one space that share edges, vertex for vertex, and whose
/// outline the ray passes on the inside, farther off than tracers see any vertex beside its place: however they see the vertices, if all triangles
/// of a vertex see it alike, the outline winds around the ray as before, and some triangle is in its way. So it is at a mesh's edge and vertex, but
/// not at its border and where it folds over. `crossings` are of all triangles in that space that the ray may meet.
std::vector<double> covers(const RayInSpace &ray, const SceneGeometry &geometry, const std::vector<Crossing> &crossings);

}  // namespace brandung
