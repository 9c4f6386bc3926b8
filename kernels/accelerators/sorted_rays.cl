// Rays of a list sorted by the axis along which they go most: rows of them share the axis by which a triangle's vertices are turned.
#pragma once
#include "kernels/accelerators/packet.cl"
#include "kernels/core/items.cl"
#include "kernels/core/major_axis.cl"

/// Work-items whose rays one of them sorts together: the more, the fewer lanes are left over.
#define CHUNKS_PER_SORT 4u
#define RAYS_PER_SORT (CHUNKS_PER_SORT * ITEMS_PER_CHUNK)

typedef struct {
    uint places[RAYS_PER_SORT];   ///< of rays in the list, axis by axis
    uint numbers[RAYS_PER_SORT];  ///< list[places[k]]
    uint ends[3];                 ///< of each axis's rays
} SortedRays;

FUNCTION void sort_rays(const global Ray *rays, const global uint *list, Chunk chunk, SortedRays *sorted) {
    uchar axes[RAYS_PER_SORT];
    uint next[3] = {0u, 0u, 0u};
    for (uint i = 0u; i < chunk.items; ++i) {
        axes[i] = (uchar)major_axis(rays[list[chunk.begin + i]].direction);
        next[axes[i]] += 1u;
    }
    next[2] = next[0] + next[1], next[1] = next[0], next[0] = 0u;
    for (uint i = 0u; i < chunk.items; ++i) {
        const uint k = next[axes[i]]++;
        sorted->places[k] = chunk.begin + i, sorted->numbers[k] = list[chunk.begin + i];
    }
    for (uint axis = 0u; axis < 3u; ++axis) sorted->ends[axis] = next[axis];
}

/// The row of sorted rays first .. first + count - 1, at most 16.
FUNCTION Row sorted_row(const global Ray *rays, const SortedRays *sorted, uint first, uint count) {
    uint numbers[ROW];
    for (uint j = 0u; j < ROW; ++j) numbers[j] = sorted->numbers[first + min(j, count - 1u)];
    return row_of(rays, numbers, count, 0, 0u);
}

/// For rows of the sorted rays: `axis` is theirs, and they are first ... first + count - 1.
#define FOR_EACH_SORTED_ROW(sorted, axis, first, count) \
    for (uint axis = 0u, first = 0u; axis < 3u; ++axis) \
        for (uint count; (count = min(ROW, (sorted)->ends[axis] - first)) > 0u; first += count)
