// Rays of a list sorted by where they go: rows of them share the axis along which they go most, by which a triangle's vertices are turned, and mostly
// the signs of their directions, so that together they meet fewer primitives.
#pragma once
#include "kernels/accelerators/packet.cl"
#include "kernels/core/counting_sort.cl"
#include "kernels/core/items.cl"
#include "kernels/core/major_axis.cl"

/// Work-items whose rays one of them sorts together: the more, the more rays of a row are alike, and the fewer lanes are left over.
#define CHUNKS_PER_SORT 16u
#define RAYS_PER_SORT (CHUNKS_PER_SORT * ITEMS_PER_CHUNK)
#define OCTANTS 8u

typedef struct {
    uint places[RAYS_PER_SORT];   ///< of rays in the list, axis by axis, and octant by octant
    uint numbers[RAYS_PER_SORT];  ///< list[places[k]]
    uint ends[3];                 ///< of each axis's rays
} SortedRays;

FUNCTION uint octant(vec3 d) { return as_uint(d.x) >> 31 | (as_uint(d.y) >> 31) << 1 | (as_uint(d.z) >> 31) << 2; }

FUNCTION void sort_rays(const global Ray *rays, const global uint *list, Chunk chunk, SortedRays *sorted) {
    uchar keys[RAYS_PER_SORT];
    uint next[3u * OCTANTS + 1u];
    count_no_keys(next, 3u * OCTANTS);
    for (uint i = 0u; i < chunk.items; ++i) {
        const vec3 direction = rays[list[chunk.begin + i]].direction;
        keys[i] = (uchar)(major_axis(direction) * OCTANTS + octant(direction));
        count_key(next, keys[i]);
    }
    begin_keys(next, 3u * OCTANTS);
    for (uint axis = 0u; axis < 3u; ++axis) sorted->ends[axis] = next[(axis + 1u) * OCTANTS];
    for (uint i = 0u; i < chunk.items; ++i) {
        const uint k = place_of_next(next, keys[i]);
        sorted->places[k] = chunk.begin + i, sorted->numbers[k] = list[chunk.begin + i];
    }
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
