// That of GPUs, for lint.
#pragma once
#include "kernels/accelerators/single_ray_x1.cl"
