// Template: records a number of each pixel's first hit, which has no mean. The includer has defined aov_number(hit).
#include "generated/instances.cl"
#include "kernels/core/bands.cl"
#include "kernels/core/items.cl"
#include "kernels/core/scene.cl"
#include "kernels/samplers/slot.cl"

/// In pixels of the band that the batch has the first sample of: the number of what that hits. Ray live[first + i] is a camera ray, its hit
/// is in instances[i], where scenes have some.
kernel void record_number(BatchParams batch, FilmBand band, LIVE_PARAMS, const global uint *restrict pixels, const global Hit *restrict hits,
                          const global uint *restrict instances, global uint *restrict numbers) {
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const PixelSample which = pixel_sample(live[first + i], batch, pixels);
        if (which.sample != 0u || !is_in_band(which.pixel, band)) continue;
        numbers[place_in_band(which.pixel, band)] = aov_number(placed(hits[i], instance_at(instances, i)));
    }
}
