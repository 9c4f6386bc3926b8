// Sums of contributions in their samples, in fixed point: the order does not matter.
#pragma OPENCL EXTENSION cl_khr_int64_base_atomics : enable
#include "generated/constants.h"
#include "kernels/core/integer128.cl"
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/load.cl"
#include "kernels/core/scene.cl"

/// In units of 2^-32, to the nearest. Magnitudes are cut at 2^17: an int64 holds them, and add_samples cuts, and counts, beyond 2^16.
FUNCTION int64 fixed_point(float x) { return (int64)rint(minimum(maximum(x, -0x1p17f), 0x1p17f) * 0x1p32f); }

/// Two items may have one sample only where rays branch.
FUNCTION void add_contribution(global Integer128 *sum, int64 contribution) {
    if (BRANCHING > 1u) {
        add_atomically(sum, contribution);
    } else {
        add(sum, contribution);
    }
}

/// Columns of a chunk.
typedef struct {
    int64 contribution[3][ITEMS_PER_WORK_ITEM];
    uint finite[ITEMS_PER_WORK_ITEM], lit[ITEMS_PER_WORK_ITEM];
} AccumulateColumns;

/// Adds contributions[i] to the sample of path live[first + i]. refused[0] counts what is not finite.
kernel void accumulate(LIVE_PARAMS, const global Path *restrict paths, const global Spectrum *restrict contributions, global Sample *restrict samples,
                       global uint *restrict refused) {
    AccumulateColumns columns;
    const uint begin = chunk_of(count).begin;
    {
        FOR_EACH_ITEM(i, count) {
            const Spectrum contribution = load(contributions + i), size = absolute(contribution);
            const uint c = i - begin;
            columns.contribution[0][c] = fixed_point(contribution.x);
            columns.contribution[1][c] = fixed_point(contribution.y);
            columns.contribution[2][c] = fixed_point(contribution.z);
            columns.finite[c] = (size.x < INFINITY) & (size.y < INFINITY) & (size.z < INFINITY);
            columns.lit[c] = largest(size) > 0.0f;
        }
    }
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const uint c = i - begin;
        if (!columns.finite[c]) atomic_inc(refused);
        if (!(columns.finite[c] & columns.lit[c])) continue;
        global Sample *sample = samples + paths[live[first + i]].slot;
        add_contribution(&sample->sum[0], columns.contribution[0][c]);
        add_contribution(&sample->sum[1], columns.contribution[1][c]);
        add_contribution(&sample->sum[2], columns.contribution[2][c]);
    }
}
