// Stable lists of the live ones among slots, in rows: count per chunk, scan the counts, write. No atomics.
#include "kernels/core/portable.h"
#include "kernels/stages/compact.h"

/// Work-items (chunk, row): chunk_counts[row * chunks + chunk] = live ones among the chunk's slots of alive[row * stride ...].
kernel void count_live(const global uchar *restrict alive, uint stride, uint count, global uint *restrict chunk_counts) {
    const uint chunk = get_global_id(0), row = get_global_id(1);
    uint sum = 0u;
    for (uint i = chunk * COMPACT_CHUNK; i < min((chunk + 1u) * COMPACT_CHUNK, count); ++i) sum += alive[row * stride + i];
    chunk_counts[row * get_global_size(0) + chunk] = sum;
}

/// Work-item (0, row) replaces a row's counts by the sums of those before them; counts[row] = their total.
kernel void scan_counts(global uint *restrict chunk_counts, uint chunks, global uint *restrict counts) {
    if (get_global_id(0) != 0) return;
    const uint row = get_global_id(1);
    uint sum = 0u;
    for (uint chunk = 0u; chunk < chunks; ++chunk) {
        const uint live = chunk_counts[row * chunks + chunk];
        chunk_counts[row * chunks + chunk] = sum;
        sum += live;
    }
    counts[row] = sum;
}

/// Work-items (chunk, row): list[row * stride + list_first ...] = base + slot of the live ones, in order. They are gathered first, without branches
/// of which a processor would guess every other wrong.
kernel void write_live(const global uchar *restrict alive, uint stride, uint count, const global uint *restrict chunk_counts, uint base,
                       uint list_first, global uint *restrict list) {
    const uint chunk = get_global_id(0), row = get_global_id(1);
    const uint begin = chunk * COMPACT_CHUNK, place = row * stride + list_first + chunk_counts[row * get_global_size(0) + chunk];
    uint slots[COMPACT_CHUNK], live = 0u;
    for (uint i = begin; i < min(begin + COMPACT_CHUNK, count); ++i) slots[live] = row * stride + i, live += alive[row * stride + i] != 0;
    for (uint k = 0u; k < live; ++k) list[place + k] = base + slots[k];
}
