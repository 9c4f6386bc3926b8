// The default's for one lane, for lint.
#include "kernels/accelerators/wide_bvh_scalar.cl"
