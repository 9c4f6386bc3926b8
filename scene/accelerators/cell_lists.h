/// Lists of what is in cells, as kernels/accelerators/cells.h has them: for every structure that divides space.
#pragma once
#include "kernels/accelerators/cells.h"
#include "scene/accelerators/accelerator.h"

namespace brandung {

/// References in cells, cell by cell: those of cell c are members[starts[c]] .. members[starts[c + 1]], ascending.
struct Cells {
    std::vector<uint> starts;   ///< one more than there are cells
    std::vector<uint> members;  ///< places in the builder's list of references; every one of them is in some cell

    std::size_t count() const { return starts.size() - 1; }
    std::span<const uint> of(std::size_t cell) const { return std::span(members).subspan(starts[cell], starts[cell + 1] - starts[cell]); }
};

/// Of all; a point for none.
Bounds bounds_of(std::span<const Reference> references);
/// Throws SceneError, which names `accelerator`, for more entries in cells than words can number.
void check_entries(std::uint64_t entries, const char *accelerator);

struct CellLists {
    std::array<std::vector<PrimitiveBlock>, MAX_PRIMITIVE_KINDS> blocks;  ///< every reference in exactly one
    std::vector<uint> lists;                                              ///< per cell: place of its first item, or NO_ITEMS
    std::vector<uint> items;
    std::vector<std::uint8_t> lanes;  ///< per item: bits of the block's primitives that are in the cell
};

/// Puts into blocks together what is in a cell together, going from cell to cell: so cells that follow each other should be neighbours.
/// Throws SceneError, which names `accelerator`, for more blocks or items than words can number.
CellLists list_cells(std::span<const Reference> references, const Cells &cells, const char *accelerator);

/// What such an accelerator has in the arena: `header`, which begins with CellSpans that this fills in, `cell_count` cells or nodes of its own, and
/// the lists.
BuiltAccelerator built_of_cells(std::vector<std::byte> header, std::span<const std::byte> cells, std::size_t cell_count, CellLists lists);

template <class Header, class Cell> BuiltAccelerator built_of_cells(const Header &header, const std::vector<Cell> &cells, CellLists lists) {
    const auto bytes = std::as_bytes(std::span(&header, 1));
    return built_of_cells({bytes.begin(), bytes.end()}, std::as_bytes(std::span(cells)), cells.size(), std::move(lists));
}

}  // namespace brandung
