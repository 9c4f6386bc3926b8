// Template: crossing of a ray with a smooth triangle, for the lane width in force; the same as with a flat one.
#define TRIANGLE_CROSSING smooth_triangle_crossing
#include "kernels/primitives/triangle_crossing.cl"
#undef TRIANGLE_CROSSING
