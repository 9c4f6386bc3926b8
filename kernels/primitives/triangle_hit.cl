// Template: crossing of a ray with a flat triangle, for the lane width in force.
#define TRIANGLE(name) triangle_##name
#include "kernels/primitives/triangle_plane.cl"
#include "kernels/primitives/triangle_crossing.cl"
#undef TRIANGLE
