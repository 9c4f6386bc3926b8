// Template: crossing of a ray with a flat triangle, for the lane width in force.
#define TRIANGLE_CROSSING triangle_crossing
#include "kernels/primitives/triangle_crossing.cl"
#undef TRIANGLE_CROSSING
