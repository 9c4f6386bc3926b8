// Sums of the tracing stages' tallies.
#include "kernels/core/items.cl"

/// The first work-item adds `count` tallies to totals[kind] = rays, totals[RAY_KINDS + kind] = hits.
kernel void tally(const global Tally *restrict tallies, uint count, global uint64 *restrict totals) {
    if (get_global_id(0) != 0) return;
    for (uint kind = 0u; kind < RAY_KINDS; ++kind) {
        uint64 rays = 0ul, hits = 0ul;
        for (uint i = 0u; i < count; ++i) rays += tallies[i].rays[kind], hits += tallies[i].hits[kind];
        totals[kind] += rays;
        totals[RAY_KINDS + kind] += hits;
    }
}
