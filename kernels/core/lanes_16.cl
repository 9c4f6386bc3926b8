// From here on geometry written on `real`, `real3` and `mask` has 16 lanes: a packet of rays against one primitive. May be included again.
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
#define real float16
#define real3 vec3x16
#define mask int16
#define REAL_BITS(x) as_int16(x)
#define BITS_REAL(x) as_float16(x)
#define twofold twofold_x16
#define twofold3 twofold3_x16
#define LaneRay ray_x16
#define LaneBox box_x16
#define Crossing crossing_x16
/// Value of primitive j of a block's column, for every ray.
#define LANE(column, j) ((float16)((column)[j]))
/// The same of a column of numbers.
#define LANE_NUMBER(column, j) ((int16)((int)(column)[j]))

#ifndef LANES_16
#define LANES_16
typedef struct {
    float16 x, y, z;
} vec3x16;
#include "kernels/core/vec_functions.cl"
#include "kernels/core/twofold.cl"

/// Bit j is set where lane j is true.
FUNCTION uint mask_bits(int16 m) {
#ifdef __AVX512F__
    return (uint)(ushort)__builtin_ia32_cmpd512_mask(m, (int16)(0), 1, (ushort)0xffff);
#else
    const uint low = (uint)((as_ulong(convert_char8(m.lo)) & 0x8040201008040201ul) * 0x0101010101010101ul >> 56);
    const uint high = (uint)((as_ulong(convert_char8(m.hi)) & 0x8040201008040201ul) * 0x0101010101010101ul >> 56);
    return low | high << 8;
#endif
}
#endif
