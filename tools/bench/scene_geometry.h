/// SceneGeometry: the primitives of a compiled scene as others than the kernels see them.
#pragma once
#include <vector>

#include "kernels/primitives/instance.h"
#include "scene/compile.h"

namespace brandung {

struct GeometryPrimitive {
    enum class Kind : uint { triangle, sphere, other };
    Kind kind;
    vec3 a, b, c;  ///< vertices; of a sphere its centre, and the radius in b.x
};

/// Primitives that share a space: those numbered first ... end - 1.
struct GeometrySpace {
    uint first, end;
};

struct SceneGeometry {
    std::vector<GeometryPrimitive> primitives;  ///< by number
    std::vector<GeometrySpace> spaces;          ///< the world, then the groups
    std::vector<Instance> instances;            ///< by number, 0 being the world, which is not in any; empty in scenes without
    bool has(GeometryPrimitive::Kind kind) const;
    /// The place in `spaces` of an instance's; 0 is the world.
    std::size_t space_of(uint instance) const;
};

/// `compiled` must still have its arena.
SceneGeometry geometry_of(const Scene &scene, const CompiledScene &compiled);

}  // namespace brandung
