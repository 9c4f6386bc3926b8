// With everything, for lint and editors.
#pragma once
#include "kernels/accelerators/two_levels.cl"
