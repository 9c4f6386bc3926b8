// The loops over items: the only lines that know a CPU from a GPU.
#pragma once
#include "kernels/core/items.h"

#ifdef CPU
// PoCL says so of loops that a later pass does vectorise.
#pragma clang diagnostic ignored "-Wpass-failed"
#define ITEMS_PER_WORK_ITEM ITEMS_PER_CHUNK
#define SIXTEEN_WIDE _Pragma("clang loop vectorize(assume_safety) vectorize_width(16)")
#define ONE_BY_ONE _Pragma("clang loop vectorize(disable)")
/// One chunk of items that the compiler makes 16 wide. The body must be flat, and no two items of a chunk may write one address.
#define FOR_EACH_ITEM(i, count)                                            \
    const uint first_item_ = get_global_id(0) * ITEMS_PER_WORK_ITEM;       \
    const uint last_item_ = min(first_item_ + ITEMS_PER_WORK_ITEM, count); \
    SIXTEEN_WIDE for (uint i = first_item_; i < last_item_; ++i)
/// All lanes compute every kind and select.
#define ONLY_IF(condition)
#else
#define ITEMS_PER_WORK_ITEM 1u
#define SIXTEEN_WIDE
#define ONE_BY_ONE
#define FOR_EACH_ITEM(i, count) for (uint i = get_global_id(0); i < count; i = count)
#define ONLY_IF(condition) if (condition)
#endif
/// The columns of a chunk that has all its items: what no item has left in a column is computed too, and not used.
#define FOR_EACH_COLUMN(c) SIXTEEN_WIDE for (uint c = 0u; c < ITEMS_PER_WORK_ITEM; ++c)
/// The same chunk, one item after another: for divergent work, of which the compiler else makes masked gathers that take longer than all of it, and
/// for sums into shared places.
#define FOR_EACH_ITEM_SERIALLY(i, count) \
    ONE_BY_ONE for (uint i = get_global_id(0) * ITEMS_PER_WORK_ITEM; i < min((uint)(get_global_id(0) + 1u) * ITEMS_PER_WORK_ITEM, count); ++i)

/// The items of this work-item: `items` of them from `begin` on.
typedef struct {
    uint begin, items;
} Chunk;

FUNCTION Chunk chunk_of(uint count) {
    Chunk chunk;
    chunk.begin = get_global_id(0) * ITEMS_PER_WORK_ITEM;
    chunk.items = chunk.begin < count ? min(count - chunk.begin, ITEMS_PER_WORK_ITEM) : 0u;
    return chunk;
}

/// Of a list, the part that this work-item has where one of every `chunks` has all their items, and the others none.
FUNCTION Chunk chunks_of(uint count, uint chunks) {
    Chunk all;
    all.begin = get_global_id(0) * ITEMS_PER_CHUNK;
    all.items = get_global_id(0) % chunks == 0u && all.begin < count ? min(count - all.begin, chunks * ITEMS_PER_CHUNK) : 0u;
    return all;
}
