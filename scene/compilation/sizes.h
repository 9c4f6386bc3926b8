/// How large a scene's records come to be, counted before any is made.
#pragma once
#include "scene/compilation/spaces.h"
#include "scene/compile.h"

namespace brandung {

/// What the arena holds at least [bytes]: as if every block were full. Nodes of accelerators, instances, materials and lights come to it.
struct LeastSizes {
    std::size_t primitives = 0;
    std::size_t blocks = 0;   ///< what tracing needs of the primitives
    std::size_t shading = 0;  ///< their shading records, and normals of vertices
    std::size_t all() const { return blocks + shading; }
};
/// Throws SceneError if there are more primitives than numbers for them.
LeastSizes least_sizes(const Scene &scene);

/// Throws SceneError, with the sizes.
void expect_to_fit(const Scene &scene, const LeastSizes &sizes, const ArenaLimit &limit);
/// The same when all records have been made: nodes and instances can be what is too much.
void expect_to_fit(const Scene &scene, const CompiledScene &compiled, const ArenaLimit &limit);

}  // namespace brandung
