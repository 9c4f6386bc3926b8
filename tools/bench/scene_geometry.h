/// SceneGeometry: the primitives of a compiled scene as others than the kernels see them.
#pragma once
#include <cstddef>
#include <vector>

#include "kernels/primitives/instance.h"
#include "runtime/selftest/oracle.h"
#include "scene/compile.h"

namespace brandung {

struct GeometryPrimitive {
    enum class Kind : uint { triangle, sphere, other };
    Kind kind;
    vec3 a, b, c;     ///< vertices; of a sphere its centre, and the radius in b.x
    uint blocks = 0;  ///< of others: place in SceneGeometry::others,
    uint lane = 0;    ///< and number there
};

/// The primitives of one kind of which nobody here has formulas of his own, in blocks as kernels read them.
struct OtherPrimitives {
    const PrimitiveOracle *oracle;
    uint count = 0;
    std::vector<std::byte> blocks;

    Lane operator[](uint i) const { return {blocks.data() + i / BLOCK_SIZE * oracle->kind().block_bytes, i % BLOCK_SIZE}; }
};

/// Primitives that share a space: those numbered first ... end - 1.
struct GeometrySpace {
    uint first, end;
};

struct SceneGeometry {
    std::vector<GeometryPrimitive> primitives;  ///< by number
    std::vector<GeometrySpace> spaces;          ///< the world, then the groups
    std::vector<Instance> instances;            ///< by number, 0 being the world, which is not in any; empty in scenes without
    std::vector<OtherPrimitives> others;        ///< by kind
    bool has(GeometryPrimitive::Kind kind) const;
    /// The place in `spaces` of an instance's; 0 is the world.
    std::size_t space_of(uint instance) const;
};

/// `compiled` must still have its arena.
SceneGeometry geometry_of(const Scene &scene, const CompiledScene &compiled);

}  // namespace brandung
