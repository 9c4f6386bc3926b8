/// The host's side of an accelerator: from boxes to blocks of primitives and nodes above them.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "kernels/core/scene.h"
#include "scene/accelerators/build_progress.h"
#include "scene/accelerators/build_quality.h"
#include "scene/bounds.h"
#include "scene/primitives/hull.h"

namespace brandung {

/// One primitive as a builder sees it; its number is its place in the list.
struct Reference {
    Bounds bounds;  ///< not empty, finite
    uint kind;      ///< number among the kinds in use, below MAX_PRIMITIVE_KINDS
};

/// Up to BLOCK_SIZE primitives of one kind: indices into the references, ascending.
struct PrimitiveBlock {
    std::array<uint, BLOCK_SIZE> references;
    uint count = 0;
};

struct BuiltAccelerator {
    std::array<std::vector<PrimitiveBlock>, MAX_PRIMITIVE_KINDS> blocks;  ///< by kind; every reference is in exactly one
    std::vector<std::byte> nodes;
    uint node_count = 0;
    bool blocks_at_root = false;  ///< whether there are blocks among the children of a hierarchy's root
};

/// The hull of a reference, for those who look closer than boxes.
using Hulls = std::function<Hull(uint reference)>;

/// `kernels/accelerators/<file>.cl` traverses what `build` makes; with `packets`, <file>_packets.cl does so with packets of rays, with `interleaved`,
/// <file>_interleaved.cl with rays in turn and <file>_root.cl with rows of rays at its root, with `scalar`, <file>_scalar.cl with rays of one lane.
/// With `rows`, few primitives are gone through block by block. Without `qualities` all are built alike.
struct AcceleratorKind {
    const char *name, *file;
    bool packets, interleaved, scalar, rows, qualities;
    /// The same for any number of threads. Throws SceneError where it cannot hold that many.
    BuiltAccelerator (*build)(std::span<const Reference> references, const Hulls &hulls, BuildQuality quality, BuildProgress &progress);
};
const std::vector<AcceleratorKind> &accelerator_kinds();
/// Throws SceneError with the list of names. Where nothing can be tried "auto" is the default, the first.
const AcceleratorKind &find_accelerator(const std::string &name);

}  // namespace brandung
