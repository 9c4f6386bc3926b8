// What samples weigh in the columns and rows of pixels about their own.
#include "kernels/core/items.cl"
#include "kernels/filters/splat.cl"
#include "kernels/samplers/slot.cl"

/// Columns of a chunk: where samples lie from the middle of their pixels.
typedef struct {
    float x[ITEMS_PER_WORK_ITEM], y[ITEMS_PER_WORK_ITEM];
} PlaceColumns;

/// Work-items (chunk of pixels, sample of the batch): weights[k * stride + j * batch.pixels + p] is f(x) / f(0) of sample j of the batch's pixel p in
/// the column of pixels k - reach to the right of its own; and in the rows below, 2 * reach + 1 strides on. `intervals`: of the filter's values in a
/// pixel's width.
kernel void weigh_splats(BatchParams batch, const global uint *restrict pixels, int reach, float intervals,
                         const global float *restrict filter_values, uint stride, global float *restrict weights) {
    const uint j = get_global_id(1), begin = chunk_of(batch.pixels).begin;
    PlaceColumns columns;
    {
        FOR_EACH_ITEM(p, batch.pixels) {
            PixelSample which;
            which.pixel = pixels[p], which.sample = batch.first_sample + j;
            const vec2 place = place_in_square(which, batch);
            columns.x[p - begin] = place.x - 0.5f, columns.y[p - begin] = place.y - 0.5f;
        }
    }
    for (int k = -reach; k <= reach; ++k) {
        global float *in_column = weights + (uint)(k + reach) * stride + j * batch.pixels, *in_row = in_column + (uint)(2 * reach + 1) * stride;
        FOR_EACH_ITEM(p, batch.pixels) {
            in_column[p] = filter_value(columns.x[p - begin] - (float)k, intervals, filter_values);
            in_row[p] = filter_value(columns.y[p - begin] - (float)k, intervals, filter_values);
        }
    }
}
