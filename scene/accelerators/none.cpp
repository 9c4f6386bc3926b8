/// No accelerator: every primitive is tested, which makes it the others' reference.
#include "scene/accelerators/accelerator.h"

namespace brandung {

/// Blocks in scene order, each of consecutive references of one kind.
BuiltAccelerator build_none(std::span<const Reference> references, const Hulls &, BuildProgress &) {
    BuiltAccelerator accelerator;
    uint previous_kind = MAX_PRIMITIVE_KINDS;
    for (uint i = 0; i < references.size(); ++i) {
        const uint kind = references[i].kind;
        std::vector<PrimitiveBlock> &blocks = accelerator.blocks[kind];
        if (kind != previous_kind || blocks.back().count == BLOCK_SIZE) blocks.push_back({});
        PrimitiveBlock &block = blocks.back();
        block.references[block.count++] = i;
        previous_kind = kind;
    }
    return accelerator;
}

}  // namespace brandung
