/// From a Scene to the arena that kernels read.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "kernels/core/scene.h"
#include "scene/scene.h"

namespace brandung {

/// The scene's records, laid out, and which kinds of things they are.
struct CompiledScene {
    SceneHeader header{};
    std::vector<std::byte> arena;
    std::vector<const PrimitiveKind *> primitives;  ///< kinds in use; a kind's place is its number on the device
    std::vector<uint> bsdfs, lights;                ///< kinds in use: places in bsdf_kinds() and light_kinds(), which are their numbers
    std::string accelerator;
    bool reflects = false, transmits = false;  ///< whether any material spawns such rays
    bool highlights = false;                   ///< whether any material has one
    bool shading_normals = false;              ///< whether any primitive has normals of its own for shading
    uint interior_size = 0;                    ///< entries of a ray's list of media: at least the number of transparent materials up to 8
    std::size_t primitive_count = 0;
    std::vector<std::size_t> counts;  ///< of primitives, by kind in use
    double accelerator_seconds = 0;
};

/// A hash of what is seen: all that the kernels read of the scene, and its cameras.
std::uint64_t scene_hash(const Scene &scene, const CompiledScene &compiled);

/// Throws SceneError if the scene is too big, or names an unknown accelerator.
CompiledScene compile(const Scene &scene);

}  // namespace brandung
