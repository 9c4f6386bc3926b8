// From the values of a batch's samples to one of the pixels about theirs.
#include "kernels/aovs/fixed_point.cl"
#include "kernels/core/bands.cl"
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/filters/splat.cl"
#include "kernels/filters/weighed.cl"

/// As add_splats; in units as add_aov.
kernel void add_aov_splats(BatchParams batch, FilmBand band, float scale, Splat splat, const global float *restrict splat_weights,
                           const global uint *restrict pixels, const global vec3 *restrict values, global AovPixel *restrict sums) {
    FOR_EACH_ITEM_SERIALLY(i, batch.pixels) {
        if (!leads_into_band(pixels[i], splat.x, splat.y, band)) continue;
        global AovPixel *pixel = sums + place_led_to(pixels[i], splat.x, splat.y, band);
        for (uint j = 0u; j < batch.samples; ++j) {
            const uint at = j * batch.pixels + i;
            const uint weight = splat_weight(splat_weights[splat.along_x + at], splat_weights[splat.along_y + at]);
            const vec3 value = scaled(values[i * batch.samples + j], scale);
            pixel->sums[0] += weighed(fixed_point(value.x), weight), pixel->sums[1] += weighed(fixed_point(value.y), weight);
            pixel->sums[2] += weighed(fixed_point(value.z), weight);
            pixel->weights += weight;
        }
    }
}
