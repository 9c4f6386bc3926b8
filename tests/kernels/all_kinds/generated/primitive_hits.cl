// Every kind, for lint and editors.
#include "kernels/primitives/disk_hit.cl"
#include "kernels/primitives/frustum_hit.cl"
#include "kernels/primitives/smooth_triangle_hit.cl"
#include "kernels/primitives/sphere_hit.cl"
#include "kernels/primitives/triangle_hit.cl"
