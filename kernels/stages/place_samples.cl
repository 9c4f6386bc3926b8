// Where in their pixels samples lie that are splatted.
#include "kernels/core/items.cl"
#include "kernels/samplers/slot.cl"

/// places[i]: of sample i of the batch, in [0, 1)².
kernel void place_samples(BatchParams batch, const global uint *restrict pixels, uint count, global vec2 *restrict places) {
    FOR_EACH_ITEM(i, count) {
        const vec2 place = place_in_square(pixel_sample(i, batch, pixels), batch);
        places[i].x = place.x, places[i].y = place.y;
    }
}
