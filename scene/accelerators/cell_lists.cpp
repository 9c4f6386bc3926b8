#include "scene/accelerators/cell_lists.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>

#include "scene/error.h"

namespace brandung {
namespace {

/// Where a reference is: its block as an item has it, and its place in there.
struct Place {
    uint item = NO_ITEMS, lane = 0;
};

class Blocks {
public:
    Blocks(std::span<const Reference> references, const char *accelerator)
        : references_(references), accelerator_(accelerator), places_(references.size()) {}

    /// A block is left unfilled where the newcomers of a cell fit into the next one, but not into this.
    void add(std::span<const uint> cell) {
        std::array<uint, MAX_PRIMITIVE_KINDS> newcomers{};
        for (const uint reference : cell) newcomers[references_[reference].kind] += is_new(reference);
        for (uint kind = 0; kind < MAX_PRIMITIVE_KINDS; ++kind)
            if (newcomers[kind] <= BLOCK_SIZE && newcomers[kind] > room(kind)) add_block(kind);
        for (const uint reference : cell)
            if (is_new(reference)) add(reference);
    }

    const Place &place(uint reference) const { return places_[reference]; }
    std::array<std::vector<PrimitiveBlock>, MAX_PRIMITIVE_KINDS> take() { return std::move(blocks_); }

private:
    bool is_new(uint reference) const { return places_[reference].item == NO_ITEMS; }
    uint room(uint kind) const { return blocks_[kind].empty() ? 0 : BLOCK_SIZE - blocks_[kind].back().count; }

    void add_block(uint kind) {
        if (blocks_[kind].size() == ITEM_BLOCK)
            throw SceneError(fmt::format("{}: cannot hold more than {} blocks of {} primitives of one kind", accelerator_, ITEM_BLOCK, BLOCK_SIZE));
        blocks_[kind].push_back({});
    }

    void add(uint reference) {
        const uint kind = references_[reference].kind;
        if (room(kind) == 0) add_block(kind);
        PrimitiveBlock &block = blocks_[kind].back();
        places_[reference] = {kind << ITEM_KIND_SHIFT | uint(blocks_[kind].size() - 1), block.count};
        block.references[block.count++] = reference;
    }

    std::span<const Reference> references_;
    const char *accelerator_;
    std::vector<Place> places_;
    std::array<std::vector<PrimitiveBlock>, MAX_PRIMITIVE_KINDS> blocks_;
};

struct Item {
    uint word;
    std::uint8_t lanes;
};

/// Ascending by block.
std::vector<Item> items_of(std::span<const uint> cell, const Blocks &blocks) {
    std::vector<Item> items;
    for (const uint reference : cell) {
        const Place &place = blocks.place(reference);
        items.push_back({place.item, std::uint8_t(1u << place.lane)});
    }
    std::ranges::sort(items, {}, &Item::word);
    std::size_t last = 0;
    for (std::size_t i = 1; i < items.size(); ++i) {
        if (items[i].word == items[last].word)
            items[last].lanes |= items[i].lanes;
        else
            items[++last] = items[i];
    }
    items.resize(items.empty() ? 0 : last + 1);
    return items;
}

constexpr std::size_t grain = 4096;  ///< cells of a task

/// Of a range of cells; places in `lists` count from its own first item.
struct Piece {
    std::vector<uint> lists, items;
    std::vector<std::uint8_t> lanes;
};

Piece list_piece(const Cells &cells, std::size_t begin, std::size_t end, const Blocks &blocks) {
    Piece piece;
    for (std::size_t cell = begin; cell < end; ++cell) {
        if (cells.of(cell).empty()) {
            piece.lists.push_back(NO_ITEMS);
            continue;
        }
        piece.lists.push_back(uint(piece.items.size()));
        for (const Item &item : items_of(cells.of(cell), blocks)) {
            piece.items.push_back(item.word);
            piece.lanes.push_back(item.lanes);
        }
        piece.items.back() |= ITEM_LAST;
    }
    return piece;
}

void append(CellLists &lists, const Piece &piece, const char *accelerator) {
    const std::size_t first = lists.items.size();
    check_entries(first + piece.items.size(), accelerator);
    for (const uint list : piece.lists) lists.lists.push_back(list == NO_ITEMS ? NO_ITEMS : uint(first) + list);
    lists.items.insert(lists.items.end(), piece.items.begin(), piece.items.end());
    lists.lanes.insert(lists.lanes.end(), piece.lanes.begin(), piece.lanes.end());
}

}  // namespace

Bounds bounds_of(std::span<const Reference> references) {
    Bounds bounds;
    for (const Reference &reference : references) bounds.add(reference.bounds);
    return references.empty() ? Bounds{vec3(0), vec3(0)} : bounds;
}

void check_entries(std::uint64_t entries, const char *accelerator) {
    if (entries >= NO_ITEMS / 2) throw SceneError(fmt::format("{}: cannot hold {} entries in its cells", accelerator, entries));
}

CellLists list_cells(std::span<const Reference> references, const Cells &cells, const char *accelerator) {
    Blocks blocks(references, accelerator);
    for (std::size_t cell = 0; cell < cells.count(); ++cell) blocks.add(cells.of(cell));
    std::vector<Piece> pieces((cells.count() + grain - 1) / grain);
    tbb::parallel_for(std::size_t(0), pieces.size(),
                      [&](std::size_t i) { pieces[i] = list_piece(cells, i * grain, std::min((i + 1) * grain, cells.count()), blocks); });
    CellLists lists;
    for (const Piece &piece : pieces) append(lists, piece, accelerator);
    lists.blocks = blocks.take();
    return lists;
}

BuiltAccelerator built_of_cells(std::vector<std::byte> header, std::span<const std::byte> cells, std::size_t cell_count, CellLists lists) {
    BuiltAccelerator accelerator{.blocks = std::move(lists.blocks), .nodes = std::move(header), .node_count = uint(cell_count)};
    std::vector<std::byte> &bytes = accelerator.nodes;
    const auto append = [&](std::span<const std::byte> more) {
        bytes.resize((bytes.size() + 15) / 16 * 16);
        const uint place = uint(bytes.size() / sizeof(uint));
        bytes.insert(bytes.end(), more.begin(), more.end());
        return place;
    };
    CellSpans spans;
    spans.cells = append(cells);
    spans.items = append(std::as_bytes(std::span(lists.items)));
    spans.lanes = append(std::as_bytes(std::span(lists.lanes)));
    std::memcpy(bytes.data(), &spans, sizeof spans);
    return accelerator;
}

}  // namespace brandung
