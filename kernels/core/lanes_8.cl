// From here on geometry written on `real`, `real3` and `mask` has 8 lanes: one ray against a block of primitives. May be included again.
#include "kernels/core/portable.h"

#undef real
#undef real3
#undef mask
#undef REAL_BITS
#undef BITS_REAL
#undef twofold
#undef twofold3
#undef LaneRay
#undef LaneBox
#undef Crossing
#undef LANE
#undef LANE_NUMBER
#define real float8
#define real3 vec3x8
#define mask int8
#define REAL_BITS(x) as_int8(x)
#define BITS_REAL(x) as_float8(x)
#define twofold twofold_x8
#define twofold3 twofold3_x8
#define LaneRay ray_x8
#define LaneBox box_x8
#define Crossing crossing_x8
/// Values of a whole block's column: lane j is primitive j.
#define LANE(column, j) (*(const global float8 *)(column))
/// The same of a column of numbers.
#define LANE_NUMBER(column, j) (*(const global int8 *)(column))

#ifndef LANES_8
#define LANES_8
typedef struct {
    float8 x, y, z;
} vec3x8;
#include "kernels/core/vec_functions.cl"
#include "kernels/core/twofold.cl"

/// Bit j is set where lane j is true.
FUNCTION uint mask_bits(int8 m) {
#ifdef __AVX__
    return (uint)__builtin_ia32_movmskps256(as_float8(m));
#else
    return (uint)((as_ulong(convert_char8(m)) & 0x8040201008040201ul) * 0x0101010101010101ul >> 56);
#endif
}
FUNCTION float first_lane(float8 v) { return v.s0; }
FUNCTION int first_lane(int8 v) { return v.s0; }
FUNCTION vec3 first_lane(vec3x8 v) { return (vec3){v.x.s0, v.y.s0, v.z.s0}; }
FUNCTION void store_lanes(float8 v, float *to) { vstore8(v, 0, to); }
#endif
