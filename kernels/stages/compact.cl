// Stable lists of the live ones among slots, in rows: count per chunk, write behind those of the chunks before. No atomics.
#include "kernels/core/portable.h"
#include "kernels/stages/compact.h"

/// Work-items (chunk, row): chunk_counts[row * chunks + chunk] = live ones among the chunk's slots of alive[row * stride ...].
kernel void count_live(const global uchar *restrict alive, uint stride, uint count, global uint *restrict chunk_counts) {
    const uint chunk = get_global_id(0), row = get_global_id(1);
    uint sum = 0u;
    for (uint i = chunk * COMPACT_CHUNK; i < min((chunk + 1u) * COMPACT_CHUNK, count); ++i) sum += alive[row * stride + i];
    chunk_counts[row * get_global_size(0) + chunk] = sum;
}

/// Work-items (chunk, row): list[row * stride + list_first ...] = base + slot of the live ones, in order; counts[row] = their number. They are
/// gathered first, without branches of which a processor would guess every other wrong. Each work-item adds up the counts before its own, which takes
/// less time than a launch that does so for all.
kernel void write_live(const global uchar *restrict alive, uint stride, uint count, const global uint *restrict chunk_counts, uint base,
                       uint list_first, global uint *restrict list, global uint *restrict counts) {
    const uint chunk = get_global_id(0), chunks = get_global_size(0), row = get_global_id(1), begin = chunk * COMPACT_CHUNK;
    const global uint *live_before = chunk_counts + row * chunks;
    uint before = 0u;
    for (uint k = 0u; k < chunk; ++k) before += live_before[k];
    uint slots[COMPACT_CHUNK], live = 0u;
    for (uint i = begin; i < min(begin + COMPACT_CHUNK, count); ++i) slots[live] = row * stride + i, live += alive[row * stride + i] != 0;
    const uint place = row * stride + list_first + before;
    for (uint k = 0u; k < live; ++k) list[place + k] = base + slots[k];
    if (chunk + 1u == chunks) counts[row] = before + live;
}
