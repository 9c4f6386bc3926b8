// Sums of contributions in their samples, in fixed point: the order does not matter.
#include "generated/constants.h"
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/scene.cl"
#pragma OPENCL EXTENSION cl_khr_int64_base_atomics : enable

/// In units of 2^-32, to the nearest. Magnitudes are cut at 2^17, so that no sample's sum can wrap; add_samples cuts, and counts, beyond 2^16.
FUNCTION int64 fixed_point(float x) { return (int64)rint(minimum(maximum(x, -0x1p17f), 0x1p17f) * 0x1p32f); }

/// Two items may have one sample only where rays branch.
FUNCTION void add(global int64 *sum, int64 value) {
    if (BRANCHING > 1u) {
        atom_add(sum, value);
    } else {
        *sum += value;
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
        add(&sample->sum[0], fixed_point(c.x));
        add(&sample->sum[1], fixed_point(c.y));
        add(&sample->sum[2], fixed_point(c.z));
    }
}
