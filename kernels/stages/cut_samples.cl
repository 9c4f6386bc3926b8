// Samples as splats take them: columns of channels that are cut.
#include "kernels/core/bright_samples.cl"
#include "kernels/core/items.cl"
#include "kernels/core/params.h"

/// Work-items (chunk of pixels, sample of the batch): values[c * stride + j * batch.pixels + p] is channel c of sample j of the batch's pixel p,
/// cut at ±2^16; clamped[0] counts the samples that were.
kernel void cut_samples(BatchParams batch, const global Sample *restrict samples, uint stride, global int64 *restrict values,
                        volatile global uint *restrict clamped) {
    const uint row = get_global_id(1);
    uint beyond = 0u;
    FOR_EACH_ITEM(p, batch.pixels) {
        const uint from = p * batch.samples + row, to = row * batch.pixels + p;
        bool is_cut = false;
#pragma unroll
        for (uint c = 0u; c < 3u; ++c) {
            Integer128 sum;
            sum.low = samples[from].sum[c].low, sum.high = samples[from].sum[c].high;
            const int64 value = nearest_within(LARGEST_SAMPLE, sum);
            values[c * stride + to] = value;
            is_cut |= !equal(sum, value);
        }
        beyond += is_cut ? 1u : 0u;
    }
    if (beyond != 0u) atomic_add(clamped, beyond);
}
