// Values of AOVs in fixed point.
#pragma once
#include "kernels/core/lanes_1.cl"

/// To the nearest; magnitudes are cut at 2^38, so that 2^24 of them fit an int64, as many as a pixel may have samples. What is splatted, and counts
/// in several pixels, is at most 2^32, a value of 1: of filters of 4 pixels 81 times 2^24 of them fit.
FUNCTION int64 fixed_point(float x) { return (int64)rint(minimum(maximum(x, -0x1p38f), 0x1p38f)); }
