// What rows of rays have met, as stages store and count it.
#pragma once
#include "kernels/accelerators/packet_hits.cl"

/// Those of the rays' lanes.
FUNCTION void hits_of_row(RowHits closest, float4 *hits) {
    const float16 columns[4] = {closest.t, closest.u, closest.v, as_float16(closest.primitive)};
    float16 rows[4];
    transpose_fields(columns, rows);
    for (uint r = 0u; r < 4u; ++r) {
        hits[r] = rows[r].s0123, hits[4u + r] = rows[r].s4567, hits[8u + r] = rows[r].s89ab, hits[12u + r] = rows[r].scdef;
    }
}

/// Bits of the rays that meet more at nearly the same place.
FUNCTION uint crowded_lanes(RowHits closest) {
    return mask_bits((closest.primitive != (uint16)(NO_HIT)) & (closest.next <= closest.t + closest.margin));
}

/// Bits of a row's first rays.
FUNCTION uint first_lanes(uint count) { return (1u << count) - 1u; }

/// Of the rays whose bits are set.
FUNCTION void count_rays(const Row *rays, uint here, const RowHits *closest, Tally *tally) {
    const uint hits = mask_bits(closest->primitive != (uint16)(NO_HIT));
    for (uint kind = 0u; kind < RAY_KINDS; ++kind) {
        const uint of_kind = here & mask_bits((rays->tag & 3) == (int16)((int)kind));
        tally->rays[kind] += popcount(of_kind);
        tally->hits[kind] += popcount(of_kind & hits);
    }
}
