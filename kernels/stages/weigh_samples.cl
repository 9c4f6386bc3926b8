// Weights of filters that are negative in places: of samples that are finished, so that nothing on their way sees them.
#include "kernels/core/integer128.cl"
#include "kernels/core/items.cl"
#include "kernels/filters/sign.cl"
#include "kernels/filters/weighed.cl"

#define LARGEST_WEIGHED (1l << 49)  ///< 2^17, which is above what add_samples cuts and counts

/// Multiplies samples[i] by its weight.
kernel void weigh_samples(BatchParams batch, FilterParams filter, const global uint *restrict pixels, uint count, global Sample *restrict samples) {
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const bool negative = has_negative_weight(pixel_sample(i, batch, pixels), batch, filter);
        for (uint c = 0u; c < 3u; ++c) {
            const int64 value = weighed(nearest_within(LARGEST_WEIGHED, samples[i].sum[c]), filter.weight), sum = negative ? -value : value;
            samples[i].sum[c].low = (uint64)sum, samples[i].sum[c].high = (uint64)(sum >> 63);
        }
    }
}
