// With everything, for lint and editors.
#pragma once
#include "kernels/accelerators/packet_two_levels.cl"
