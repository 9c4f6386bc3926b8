// With everything, for lint and editors.
#include "kernels/accelerators/moving_instance_rows.cl"
