// What samples weigh in the columns and rows of pixels about their own.
#include "kernels/core/items.cl"
#include "kernels/filters/splat.cl"
#include "kernels/samplers/slot.cl"

/// Columns of a chunk: where samples lie from the middle of their pixels.
typedef struct {
    float x[ITEMS_PER_WORK_ITEM], y[ITEMS_PER_WORK_ITEM];
} PlaceColumns;

/// weights[k * stride + i]: f(x) / f(0) of sample i of the batch in the column of pixels k - reach to the right of its own; and in the rows below,
/// 2 * reach + 1 strides on. `intervals`: of the filter's values in a pixel's width.
kernel void weigh_splats(BatchParams batch, const global uint *restrict pixels, uint count, int reach, float intervals,
                         const global float *restrict filter_values, uint stride, global float *restrict weights) {
    const uint begin = chunk_of(count).begin;
    PlaceColumns columns;
    {
        FOR_EACH_ITEM(i, count) {
            const vec2 place = place_in_square(pixel_sample(i, batch, pixels), batch);
            columns.x[i - begin] = place.x - 0.5f, columns.y[i - begin] = place.y - 0.5f;
        }
    }
    for (int k = -reach; k <= reach; ++k) {
        global float *in_column = weights + (uint)(k + reach) * stride, *in_row = in_column + (uint)(2 * reach + 1) * stride;
        FOR_EACH_ITEM(i, count) {
            in_column[i] = filter_value(columns.x[i - begin] - (float)k, intervals, filter_values);
            in_row[i] = filter_value(columns.y[i - begin] - (float)k, intervals, filter_values);
        }
    }
}
