// With everything, for lint and editors.
#pragma once
#include "kernels/lights/environment_density.cl"
