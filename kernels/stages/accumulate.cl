// Sums of contributions in their samples, in fixed point: the order does not matter.
#pragma OPENCL EXTENSION cl_khr_int64_base_atomics : enable
#include "generated/constants.h"
#include "kernels/core/integer128.cl"
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/scene.cl"

/// In units of 2^-32, to the nearest. Magnitudes are cut at 2^17: an int64 holds them, and add_samples cuts, and counts, beyond 2^16.
FUNCTION int64 fixed_point(float x) { return (int64)rint(minimum(maximum(x, -0x1p17f), 0x1p17f) * 0x1p32f); }

/// Two items may have one sample only where rays branch.
FUNCTION void add_contribution(global Integer128 *sum, float contribution) {
    if (BRANCHING > 1u) {
        add_atomically(sum, fixed_point(contribution));
    } else {
        add(sum, fixed_point(contribution));
    }
}

/// Adds contributions[i] to the sample of path live[first + i]. refused[0] counts what is not finite.
kernel void accumulate(LIVE_PARAMS, const global Path *restrict paths, const global Spectrum *restrict contributions, global Sample *restrict samples,
                       global uint *restrict refused) {
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const Spectrum c = contributions[i];
        if (!(isfinite(c.x) && isfinite(c.y) && isfinite(c.z))) {
            atomic_inc(refused);
            continue;
        }
        global Sample *sample = samples + paths[live[first + i]].slot;
        add_contribution(&sample->sum[0], c.x);
        add_contribution(&sample->sum[1], c.y);
        add_contribution(&sample->sum[2], c.z);
    }
}
