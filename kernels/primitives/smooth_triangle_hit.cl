// Template: crossing of a ray with a smooth triangle, for the lane width in force; the same as with a flat one.
#define TRIANGLE(name) smooth_triangle_##name
#include "kernels/primitives/triangle_plane.cl"
#include "kernels/primitives/triangle_crossing.cl"
#undef TRIANGLE
