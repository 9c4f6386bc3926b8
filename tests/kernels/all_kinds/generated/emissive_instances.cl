// With everything, for lint and editors.
#pragma once
#include "kernels/lights/emissive_instances.cl"
