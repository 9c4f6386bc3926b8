// From here on geometry written on `real`, `real3` and `mask` has one lane. May be included again.
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
#define real float
#define real3 vec3
#define mask int
#define REAL_BITS(x) as_int(x)
#define BITS_REAL(x) as_float(x)
#define twofold twofold_x1
#define twofold3 twofold3_x1
#define LaneRay ray_x1
#define LaneBox box_x1
#define Crossing crossing_x1
/// Value of primitive j of a block's column.
#define LANE(column, j) ((column)[j])
/// The same of a column of numbers.
#define LANE_NUMBER(column, j) ((int)(column)[j])

#ifndef LANES_1
#define LANES_1
#include "kernels/core/vec_functions.cl"
#include "kernels/core/twofold.cl"

FUNCTION uint mask_bits(int m) { return m != 0; }
FUNCTION float first_lane(float v) { return v; }
FUNCTION int first_lane(int v) { return v; }
FUNCTION vec3 first_lane(vec3 v) { return v; }
FUNCTION void store_lanes(float v, float *to) { *to = v; }
#endif
