/// What a kd-tree divides: blocks of primitives that lie near each other, as a bounding volume hierarchy has them in its leaves. Planes through
/// primitives one by one would leave a cell with pieces of many blocks, and all 8 of each are tested at once.
#pragma once
#include "scene/accelerators/accelerator.h"
#include "scene/accelerators/kd_split.h"

namespace brandung {

struct KdBlocks {
    std::array<std::vector<PrimitiveBlock>, MAX_PRIMITIVE_KINDS> blocks;  ///< by kind; every reference is in exactly one
    std::vector<KdReference> references;                                  ///< one per block, neighbours near each other
    std::vector<uint> items;                                              ///< for each, as a list has it (cells.h)
};

/// `references` by their numbers, `kd_references` likewise, as boxes alone. Counts every reference once as progress. Throws SceneError, which names
/// `accelerator`, for more blocks than items can number.
KdBlocks kd_blocks(std::span<const Reference> references, std::span<const KdReference> kd_references, const char *accelerator,
                   BuildProgress &progress);

}  // namespace brandung
