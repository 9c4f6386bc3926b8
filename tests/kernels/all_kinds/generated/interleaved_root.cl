// The default, for lint and editors.
#include "kernels/accelerators/wide_bvh_root.cl"
