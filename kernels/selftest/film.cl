// Integers of 128 bits and the fixed point of contributions.
#include "kernels/stages/accumulate.cl"

/// What the functions make of a, b and x, in the order of FilmResult's fields.
typedef struct {
    Integer128 sum, added;
    int64 nearest, fixed;
    float rounded;
    uint equal;
} FilmResult;

kernel void test_film(const global Integer128 *restrict a, const global Integer128 *restrict b, const global float *restrict x, uint count,
                      global FilmResult *restrict results) {
    FOR_EACH_ITEM_SERIALLY(i, count) {
        results[i].sum = plus(a[i], b[i]);
        results[i].added = a[i];
        add(&results[i].added, (int64)b[i].low);
        results[i].nearest = nearest_within(1l << 48, a[i]);
        results[i].fixed = fixed_point(x[i]);
        results[i].rounded = to_float(a[i]);
        results[i].equal = equal(a[i], (int64)a[i].low);
    }
}
