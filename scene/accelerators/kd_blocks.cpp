#include "scene/accelerators/kd_blocks.h"

#include <fmt/format.h>

#include <algorithm>

#include "kernels/accelerators/cells.h"
#include "scene/accelerators/bvh2.h"
#include "scene/error.h"

namespace brandung {
namespace {

constexpr uint slack = 16;  ///< levels that the hierarchy may have beyond a balanced one

PrimitiveBlock block_of(const Bvh2 &tree, const Bvh2Node &node) {
    PrimitiveBlock block{.references = {}, .count = node.count};
    for (uint i = 0; i < node.count; ++i) block.references[i] = tree.references[node.first + i].index;
    std::sort(block.references.begin(), block.references.begin() + node.count);
    return block;
}

KdReference box_of(const PrimitiveBlock &block, std::span<const KdReference> references, uint index) {
    Bounds box;
    for (uint i = 0; i < block.count; ++i) box.add({references[block.references[i]].low, references[block.references[i]].high});
    return {box.low, index, box.high};
}

}  // namespace

KdBlocks kd_blocks(std::span<const Reference> references, std::span<const KdReference> kd_references, const char *accelerator,
                   BuildProgress &progress) {
    KdBlocks result;
    if (references.empty()) return result;
    const Bvh2 tree = build_bvh2(references, slack, progress);
    const auto visit = [&](const auto &visit, uint index) -> void {
        const Bvh2Node &node = tree.nodes[index];
        if (!node.fits_block()) {
            visit(visit, node.children);
            visit(visit, node.children + 1);
            return;
        }
        const uint kind = node.box.kind();
        std::vector<PrimitiveBlock> &blocks = result.blocks[kind];
        if (blocks.size() == ITEM_BLOCK)
            throw SceneError(fmt::format("{}: cannot hold more than {} blocks of {} primitives of one kind", accelerator, ITEM_BLOCK, BLOCK_SIZE));
        result.items.push_back(kind << ITEM_KIND_SHIFT | uint(blocks.size()));
        blocks.push_back(block_of(tree, node));
        result.references.push_back(box_of(blocks.back(), kd_references, uint(result.references.size())));
    };
    visit(visit, 0);
    return result;
}

}  // namespace brandung
