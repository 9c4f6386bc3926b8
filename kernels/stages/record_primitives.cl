// AOV: numbers of primitives, which have no mean.
#include "kernels/core/bands.cl"
#include "kernels/core/items.cl"
#include "kernels/core/scene.cl"
#include "kernels/samplers/slot.cl"

/// In pixels of the band that the batch has the first sample of: what that hits. Ray live[first + i] is a camera ray, its slot first + i.
kernel void record_primitives(BatchParams batch, FilmBand band, LIVE_PARAMS, const global uint *restrict pixels, const global Hit *restrict hits,
                              global uint *restrict primitives) {
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const PixelSample which = pixel_sample(first + i, batch, pixels);
        if (which.sample == 0u && is_in_band(which.pixel, band)) primitives[place_in_band(which.pixel, band)] = hits[i].primitive;
    }
}
