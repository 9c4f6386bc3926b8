/// What a structure of cells holds, read back from what kernels would read.
#pragma once
#include <cstring>
#include <set>
#include <vector>

#include "kernels/accelerators/cells.h"
#include "scene/accelerators/accelerator.h"

namespace brandung {

/// A box in double precision, and the references listed in it.
struct DecodedCell {
    glm::dvec3 low, high;
    std::set<uint> references;
};

class DecodedLists {
public:
    explicit DecodedLists(const BuiltAccelerator &built) : built_(built), spans_(at<CellSpans>(0)) {}

    template <class T> T at(std::size_t byte) const {
        T value;
        std::memcpy(&value, built_.nodes.data() + byte, sizeof value);
        return value;
    }
    uint cells() const { return spans_.cells; }
    uint cell_word(std::size_t i) const { return at<uint>(4 * (spans_.cells + i)); }

    /// Of a list's place, as the bits of its items' lanes say.
    std::set<uint> list(uint place) const {
        std::set<uint> references;
        if (place == NO_ITEMS) return references;
        for (std::size_t i = place;; ++i) {
            const uint item = at<uint>(4 * (spans_.items + i));
            const auto lanes = at<std::uint8_t>(4 * spans_.lanes + i);
            const PrimitiveBlock &block = built_.blocks.at(item >> ITEM_KIND_SHIFT & 7u).at(item & ITEM_BLOCK);
            for (uint lane = 0; lane < BLOCK_SIZE; ++lane)
                if (lanes >> lane & 1u) references.insert(block.references.at(lane));
            if (item & ITEM_LAST) return references;
        }
    }

private:
    const BuiltAccelerator &built_;
    CellSpans spans_;
};

std::vector<DecodedCell> decode_uniform_grid(const BuiltAccelerator &built);
std::vector<DecodedCell> decode_octree(const BuiltAccelerator &built);

}  // namespace brandung
