// Functions of kernels/core/ on arrays, in the loops of 16 lanes in which stages call them, in the precision in force.
#include "generated/precision.cl"
#include "kernels/core/items.cl"
#include "kernels/core/math.cl"
#include "kernels/core/random.cl"
#include "kernels/core/refraction.cl"

#define ON_ARRAYS(name, value)                                                                                              \
    kernel void test_##name(const global float *restrict a, const global float *restrict b, const global float *restrict c, \
                            const global float *restrict d, uint count, global float *restrict results) {                   \
        FOR_EACH_ITEM(i, count) {                                                                                           \
            results[i] = value;                                                                                             \
        }                                                                                                                   \
    }

ON_ARRAYS(multiply_then_add, a[i] * b[i] + c[i])
ON_ARRAYS(fused_multiply_add, fma(a[i], b[i], c[i]))
ON_ARRAYS(divide, a[i] / b[i])
ON_ARRAYS(square_root, sqrt(a[i]))
ON_ARRAYS(exponential, exponential(a[i]))
ON_ARRAYS(logarithm, logarithm(a[i]))
ON_ARRAYS(power, power(a[i], b[i]))
ON_ARRAYS(arctangent, arctangent(a[i], b[i]))
ON_ARRAYS(turn_cosine, turn(a[i]).x)
ON_ARRAYS(turn_sine, turn(a[i]).y)
ON_ARRAYS(next_up, next_up(a[i]))
ON_ARRAYS(next_down, next_down(a[i]))
ON_ARRAYS(difference_of_products, difference_of_products(a[i], b[i], c[i], d[i]))
ON_ARRAYS(refracted_cosine_squared, refracted_cosine_squared(a[i], b[i]))
ON_ARRAYS(fresnel, fresnel(a[i], b[i], c[i]))
ON_ARRAYS(hash, unit_interval(hash(as_uint(a[i]))))
#undef ON_ARRAYS
