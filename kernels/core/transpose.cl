// Between 16 records in memory and columns of 16 lanes, by shuffles: scalar stores that a vector load reads again would stall it.
#pragma once
#include "kernels/core/items.h"

/// Of every four lanes of a and b the lower (upper) two, alternating.
FUNCTION float16 interleave_low(float16 a, float16 b) {
    return (float16)(a.s0, b.s0, a.s1, b.s1, a.s4, b.s4, a.s5, b.s5, a.s8, b.s8, a.s9, b.s9, a.sc, b.sc, a.sd, b.sd);
}
FUNCTION float16 interleave_high(float16 a, float16 b) {
    return (float16)(a.s2, b.s2, a.s3, b.s3, a.s6, b.s6, a.s7, b.s7, a.sa, b.sa, a.sb, b.sb, a.se, b.se, a.sf, b.sf);
}

/// Four fields of 16 records: columns[f] becomes their fields f, where quarter q of rows[r] has the fields of record 4 q + r.
/// The same shuffles lead from columns to rows.
FUNCTION void transpose_fields(const float16 *rows, float16 *columns) {
    const float16 low02 = interleave_low(rows[0], rows[2]), high02 = interleave_high(rows[0], rows[2]);
    const float16 low13 = interleave_low(rows[1], rows[3]), high13 = interleave_high(rows[1], rows[3]);
    columns[0] = interleave_low(low02, low13), columns[1] = interleave_high(low02, low13);
    columns[2] = interleave_low(high02, high13), columns[3] = interleave_high(high02, high13);
}
