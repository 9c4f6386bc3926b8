// From here on geometry written on `real`, `real3` and `mask` has one lane. May be included again.
#include "kernels/core/portable.h"

#undef real
#undef real3
#undef mask
#undef LANE
#define real float
#define real3 vec3
#define mask int
/// Value of primitive j of a block's column.
#define LANE(column, j) ((column)[j])

#ifndef LANES_1
#define LANES_1
#include "kernels/core/vec_functions.cl"

FUNCTION uint mask_bits(int m) { return (uint)m; }
#endif
