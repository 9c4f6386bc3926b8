// Where in and about a pixel the filter in use puts a sample, by one random number, in the precision in force.
#include "generated/precision.cl"
#include "generated/filter.cl"
#include "kernels/core/items.cl"

kernel void test_filter_places(FILTER_PARAMS, const global float *restrict randoms, uint count, global float *restrict places) {
    FOR_EACH_ITEM_SERIALLY(i, count) { places[i] = filter_place(randoms[i], filter, filter_table); }
}
