// From the values of a batch's samples to sums of pixels.
#include "kernels/aovs/fixed_point.cl"
#include "kernels/core/bands.cl"
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/filters/splat.h"

/// Adds values to their pixels, as far as these are in the band, in units of 1 / scale, a power of two. Those with infinity in x do not count.
kernel void add_aov(BatchParams batch, FilmBand band, float scale, const global uint *restrict pixels, const global vec3 *restrict values,
                    global AovPixel *restrict sums) {
    FOR_EACH_ITEM_SERIALLY(i, batch.pixels) {
        if (!is_in_band(pixels[i], band)) continue;
        global AovPixel *pixel = sums + place_in_band(pixels[i], band);
        for (uint j = 0u; j < batch.samples; ++j) {
            const vec3 value = scaled(values[i * batch.samples + j], scale);
            if (!(isfinite(value.x) && isfinite(value.y) && isfinite(value.z))) continue;
            pixel->sums[0] += fixed_point(value.x), pixel->sums[1] += fixed_point(value.y), pixel->sums[2] += fixed_point(value.z);
            pixel->weights += SPLAT_UNIT;
        }
    }
}
