// The default, for lint and editors.
#pragma once
#include "kernels/samplers/sobol.cl"
