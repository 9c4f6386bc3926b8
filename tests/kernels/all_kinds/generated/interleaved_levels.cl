// With everything, for lint and editors.
#include "kernels/accelerators/interleaved_two_levels.cl"
