// Weights of filters that are negative in places: of values of samples beside their radiance.
#include "kernels/core/items.cl"
#include "kernels/filters/sign.cl"

/// Multiplies values[i], the value of sample i, by its weight.
kernel void weigh_values(BatchParams batch, FilterParams filter, const global uint *restrict pixels, uint count, global vec3 *restrict values) {
    const float weight = (float)filter.weight * 0x1p-30f;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const bool negative = has_negative_weight(pixel_sample(i, batch, pixels), batch, filter);
        values[i] = scaled(values[i], negative ? -weight : weight);
    }
}
