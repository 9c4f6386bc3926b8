// With everything, for lint and editors.
#pragma once
#include "kernels/primitives/moving_instance.cl"
