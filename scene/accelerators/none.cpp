/// No accelerator: every primitive is tested, which makes it the others' reference.
#include "scene/accelerators/accelerator.h"

namespace brandung {

/// Blocks in scene order, each full but the last of its kind.
BuiltAccelerator build_none(std::span<const Reference> references, const Hulls &, BuildQuality, BuildProgress &) {
    BuiltAccelerator accelerator;
    for (uint i = 0; i < references.size(); ++i) {
        std::vector<PrimitiveBlock> &blocks = accelerator.blocks[references[i].kind];
        if (blocks.empty() || blocks.back().count == BLOCK_SIZE) blocks.push_back({});
        PrimitiveBlock &block = blocks.back();
        block.references[block.count++] = i;
    }
    return accelerator;
}

}  // namespace brandung
