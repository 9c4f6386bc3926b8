// That of CPUs, for lint and editors.
#pragma once
#include "kernels/accelerators/single_ray_x8.cl"
